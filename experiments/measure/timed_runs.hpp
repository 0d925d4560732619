// SPDX-License-Identifier: GPL-3.0-or-later
//
// What timings of points, segments and triangles have in common: contestants whose input is prepared, each
// in its own scalar, whose answers are checked first, and that then run in turn.
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "experiments/measure/batches.hpp"
#include "experiments/measure/promise.hpp"
#include "experiments/measure/timing.hpp"

namespace clipscope::experiments {

// Primitives of one view, which must outlive whoever uses them.
template <std::size_t N>
struct RunBatch {
  const View* view;
  std::span<const Simplex<Space::view, float, kSceneAttributes, N>> primitives;
};

// The batches in one scalar.
template <class T, std::size_t N>
struct RunInput {
  std::vector<Projection<T>> projections;
  std::vector<std::vector<Simplex<Space::view, T, kSceneAttributes, N>>> primitives;
  std::size_t size = 0;  // primitives in all

  explicit RunInput(std::span<const RunBatch<N>> batches) {
    for (const RunBatch<N>& batch : batches) {
      projections.push_back(projection_of<T>(*batch.view));
      primitives.push_back(simplices_cast<T>(batch.primitives));
      size += batch.primitives.size();
    }
  }
};

// Makes the input in a scalar when it is first asked for; all contestants in that scalar share it.
template <std::size_t N>
class RunInputs {
 public:
  explicit RunInputs(std::vector<RunBatch<N>> batches) : batches_(std::move(batches)) {}

  template <class T>
  const RunInput<T, N>& in() {
    auto& input = std::get<std::unique_ptr<RunInput<T, N>>>(inputs_);
    if (!input) input = std::make_unique<RunInput<T, N>>(batches_);
    return *input;
  }

 private:
  template <class... Ts>
  static std::tuple<std::unique_ptr<RunInput<Ts, N>>...> none(TypeList<Ts...>);

  std::vector<RunBatch<N>> batches_;
  decltype(none(AllScalars{})) inputs_;
};

// A contestant with its input.
class TimedRun {
 public:
  virtual ~TimedRun() = default;
  // Clips the leading share of each batch; ns per primitive.
  virtual double run() = 0;
  // Chooses the share so that a run takes about so long, and warms up.
  virtual void choose_share(double target_ns) = 0;
  // Of about so many primitives, spread over the batches; empty if all promises are kept.
  virtual std::string first_broken_promise(std::size_t primitives) = 0;
};

// checks(b) gives a function that judges an answer to a primitive of batch b:
// check(promise, number of the primitive, polygon) -> PromiseCheck.
template <class T, std::size_t N, class Checks>
class TimedRunOf final : public TimedRun {
 public:
  // Pre-condition: the input has a primitive, and outlives this.
  TimedRunOf(const Contestant<T, N>& contestant, const RunInput<T, N>& input, Checks checks)
      : contestant_(contestant), input_(input), checks_(std::move(checks)) {}

  double run() override { return run_share(share_); }

  void choose_share(double target_ns) override {
    const double count = static_cast<double>(input_.size);
    const double least = std::min(1.0, kLeastPrimitives / count);
    share_ = std::clamp(target_ns / (run_share(least) * count), least, 1.0);
    run_share(share_);
  }

  std::string first_broken_promise(std::size_t limit) override {
    for (std::size_t b = 0; b < input_.primitives.size(); ++b) {
      const auto& primitives = input_.primitives[b];
      const std::size_t share = std::max<std::size_t>(1, limit * primitives.size() / input_.size);
      const std::size_t count = std::min(share, primitives.size());
      const auto check = checks_(b);
      out_.clear();
      contestant_.view(input_.projections[b], std::span(primitives).first(count), out_);
      std::vector<PromiseCheck> found(count);
      tbb::parallel_for(std::size_t{0}, count,
                        [&](std::size_t i) { found[i] = check(contestant_.promise, i, out_[i]); });
      for (const PromiseCheck& f : found) {
        if (f.verdict == PromiseVerdict::broken) return f.reason;
      }
    }
    return "";
  }

 private:
  static constexpr double kLeastPrimitives = 64;
  static constexpr std::size_t kBlock = 1024;  // primitives whose output stays in cache

  double run_share(double share) {
    using Clock = std::chrono::steady_clock;
    std::size_t clipped = 0;
    const Clock::time_point start = Clock::now();
    for (std::size_t b = 0; b < input_.primitives.size(); ++b) {
      const auto& primitives = input_.primitives[b];
      const double wanted = std::ceil(share * static_cast<double>(primitives.size()));
      const std::size_t count = std::min(static_cast<std::size_t>(wanted), primitives.size());
      for (std::size_t first = 0; first < count; first += kBlock) {
        out_.clear();
        contestant_.view(input_.projections[b],
                         std::span(primitives).subspan(first, std::min(kBlock, count - first)),
                         out_);
      }
      clipped += count;
    }
    const std::chrono::duration<double, std::nano> spent = Clock::now() - start;
    return spent.count() / static_cast<double>(clipped);
  }

  const Contestant<T, N>& contestant_;
  const RunInput<T, N>& input_;
  Checks checks_;
  PolygonStream<T, kSceneAttributes> out_;
  double share_ = 1.0;
};

template <class T, std::size_t N, class Checks>
std::unique_ptr<TimedRun> make_timed_run(const Contestant<T, N>& contestant,
                                         const RunInput<T, N>& input, Checks checks) {
  return std::make_unique<TimedRunOf<T, N, Checks>>(contestant, input, std::move(checks));
}

// One timing for each of `count` contestants, in their order: prepare(i) makes the run of contestant i. Those
// that break their promise are not timed. Ratios refer to the baseline's run of the same round.
std::vector<Timing> time_in_turn(
    std::unique_ptr<TimedRun> baseline, std::size_t count,
    const std::function<std::unique_ptr<TimedRun>(std::size_t)>& prepare,
    const TimingOptions& options);

}  // namespace clipscope::experiments

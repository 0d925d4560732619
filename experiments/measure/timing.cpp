// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/measure/timing.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <random>
#include <tuple>

#include "experiments/measure/batches.hpp"
#include "experiments/measure/machine.hpp"
#include "experiments/measure/promise.hpp"

namespace clipscope::experiments {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kLeastTriangles = 64;
constexpr std::size_t kBlock = 1024;  // triangles whose output stays in cache

double nanoseconds(Clock::duration d) {
  return std::chrono::duration<double, std::nano>(d).count();
}

std::size_t triangle_count(std::span<const TimedBatch> batches) {
  std::size_t count = 0;
  for (const TimedBatch& batch : batches) count += batch.triangles.size();
  return count;
}

// The batches in one scalar, made once for all its contestants.
template <class T>
struct InputIn {
  std::vector<Projection<T>> projections;
  std::vector<std::vector<ViewTriangle<T, kSceneAttributes>>> triangles;

  explicit InputIn(std::span<const TimedBatch> batches) {
    for (const TimedBatch& batch : batches) {
      projections.push_back(projection_of<T>(batch.view));
      triangles.push_back(triangles_cast<T>(batch.triangles));
    }
  }
};

// Makes the input in a scalar when it is first asked for.
class Inputs {
 public:
  explicit Inputs(std::span<const TimedBatch> batches) : batches_(batches) {}

  std::span<const TimedBatch> batches() const { return batches_; }

  template <class T>
  const InputIn<T>& in() {
    auto& input = std::get<std::unique_ptr<InputIn<T>>>(inputs_);
    if (!input) input = std::make_unique<InputIn<T>>(batches_);
    return *input;
  }

 private:
  template <class... Ts>
  static std::tuple<std::unique_ptr<InputIn<Ts>>...> none(TypeList<Ts...>);

  std::span<const TimedBatch> batches_;
  decltype(none(AllScalars{})) inputs_;
};

// A contestant with its input in its own scalar.
class Runner {
 public:
  virtual ~Runner() = default;
  // Clips the leading share of each batch; ns per triangle.
  virtual double run() = 0;
  virtual void choose_share(double target_ns) = 0;
  virtual std::string first_broken_promise(std::size_t triangles) = 0;
};

template <class T>
class RunnerOf final : public Runner {
 public:
  RunnerOf(const Contestant<T>& contestant, Inputs& inputs)
      : contestant_(contestant),
        source_(inputs.batches()),
        projections_(inputs.in<T>().projections),
        triangles_(inputs.in<T>().triangles) {}

  double run() override { return run_share(share_); }

  void choose_share(double target_ns) override {
    const double count = static_cast<double>(triangle_count(source_));
    const double least = std::min(1.0, kLeastTriangles / count);
    const double ns_per_triangle = run_share(least);
    share_ = std::clamp(target_ns / (ns_per_triangle * count), least, 1.0);
    run_share(share_);
  }

  std::string first_broken_promise(std::size_t limit) override {
    const std::size_t all = triangle_count(source_);
    for (std::size_t b = 0; b < triangles_.size(); ++b) {
      const std::size_t share = std::max<std::size_t>(1, limit * triangles_[b].size() / all);
      const std::size_t count = std::min(share, triangles_[b].size());
      const PromiseChecker checker(frustum_cast<double>(source_[b].view.frustum));
      out_.clear();
      contestant_.view(projections_[b], std::span(triangles_[b]).first(count), out_);
      std::vector<PromiseCheck> checks(count);
      tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        checks[i] = checker.check<T, kSceneAttributes>(
            contestant_.promise, reference::input_triangle(source_[b].triangles[i]), out_[i]);
      });
      for (const PromiseCheck& check : checks) {
        if (check.verdict == PromiseVerdict::broken) return check.reason;
      }
    }
    return "";
  }

 private:
  double run_share(double share) {
    std::size_t clipped = 0;
    const Clock::time_point start = Clock::now();
    for (std::size_t b = 0; b < triangles_.size(); ++b) {
      const double wanted = std::ceil(share * static_cast<double>(triangles_[b].size()));
      const std::size_t count = std::min(static_cast<std::size_t>(wanted), triangles_[b].size());
      for (std::size_t first = 0; first < count; first += kBlock) {
        out_.clear();
        contestant_.view(projections_[b],
                         std::span(triangles_[b]).subspan(first, std::min(kBlock, count - first)),
                         out_);
      }
      clipped += count;
    }
    return nanoseconds(Clock::now() - start) / static_cast<double>(clipped);
  }

  const Contestant<T>& contestant_;
  std::span<const TimedBatch> source_;
  const std::vector<Projection<T>>& projections_;
  const std::vector<std::vector<ViewTriangle<T, kSceneAttributes>>>& triangles_;
  PolygonStream<T, kSceneAttributes> out_;
  double share_ = 1.0;
};

std::unique_ptr<Runner> make_runner(const AnyContestant& contestant, Inputs& inputs) {
  return std::visit(
      [&]<class T>(const Contestant<T>* c) -> std::unique_ptr<Runner> {
        return std::make_unique<RunnerOf<T>>(*c, inputs);
      },
      contestant);
}

}  // namespace

AnyContestant baseline() { return find_contestant("textbook", "float"); }

std::vector<Timing> measure_time(std::span<const TimedBatch> batches,
                                 std::span<const AnyContestant> contestants,
                                 const TimingOptions& options) {
  std::vector<Timing> timings(contestants.size());
  if (triangle_count(batches) == 0) {
    for (Timing& timing : timings) timing.refused = "no triangles";
    return timings;
  }
  const double target_ns = options.milliseconds_per_run * 1e6;
  Inputs inputs(batches);
  const auto prepare = [&](const AnyContestant& contestant) {
    std::unique_ptr<Runner> runner = make_runner(contestant, inputs);
    runner->choose_share(target_ns);
    return runner;
  };

  std::vector<std::unique_ptr<Runner>> runners;
  runners.push_back(prepare(baseline()));
  std::vector<std::size_t> timed;  // whose runner is the next one
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    std::unique_ptr<Runner> runner = prepare(contestants[i]);
    timings[i].refused = runner->first_broken_promise(options.checked_triangles);
    if (!timings[i].refused.empty()) continue;
    timed.push_back(i);
    runners.push_back(std::move(runner));
  }
  if (timed.empty()) return timings;

  std::vector<std::function<double()>> tasks;
  for (const auto& runner : runners) tasks.push_back([&runner] { return runner->run(); });
  const std::vector<std::vector<double>> samples = run_in_turn(tasks, options.rounds);
  for (std::size_t i = 0; i < timed.size(); ++i) {
    Timing& timing = timings[timed[i]];
    timing.samples_ns = samples[i + 1];
    timing.ns = median_interval(timing.samples_ns);
    timing.speedup = median_interval(ratios(samples[0], timing.samples_ns));
  }
  return timings;
}

std::vector<std::vector<double>> run_in_turn(std::span<const std::function<double()>> tasks,
                                             int rounds) {
  const PinnedThread pinned;
  std::vector<std::vector<double>> samples(tasks.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      const std::size_t turn = (i + static_cast<std::size_t>(round)) % tasks.size();
      samples[turn].push_back(tasks[turn]());
    }
  }
  return samples;
}

std::vector<double> ratios(std::span<const double> numerators,
                           std::span<const double> denominators) {
  std::vector<double> result;
  for (std::size_t i = 0; i < numerators.size(); ++i) {
    result.push_back(numerators[i] / denominators[i]);
  }
  return result;
}

std::vector<TimedBatch> timed_batches(const Scene& scene, std::size_t limit) {
  std::vector<TimedBatch> batches;
  const Sample sample = sample_of(scene, std::max<std::size_t>(1, limit / scene.views.size()));
  std::mt19937_64 generator(1);
  for (const View& view : scene.views) {
    TimedBatch batch{view, sampled_view_triangles(scene, view, sample, 0, sample.count)};
    for (std::size_t i = 0; i < sample.count; ++i) batch.numbers.push_back(i * sample.stride);
    for (std::size_t i = batch.triangles.size(); i > 1; --i) {
      const std::size_t other = generator() % i;
      std::swap(batch.triangles[i - 1], batch.triangles[other]);
      std::swap(batch.numbers[i - 1], batch.numbers[other]);
    }
    batches.push_back(std::move(batch));
  }
  return batches;
}

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/segments/timing.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>

#include "experiments/measure/batches.hpp"
#include "experiments/segments/promise_check.hpp"

namespace clipscope::experiments {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kLeastSegments = 64;
constexpr std::size_t kBlock = 1024;  // segments whose output stays in cache
constexpr int K = kSceneAttributes;

// A contestant with its input in its own scalar.
class Runner {
 public:
  virtual ~Runner() = default;
  // Clips the leading share of each batch; ns per segment.
  virtual double run() = 0;
  virtual void choose_share(double target_ns) = 0;
  virtual std::string first_broken_promise(std::size_t segments) = 0;
};

template <class T>
class RunnerOf final : public Runner {
 public:
  RunnerOf(const Contestant<T, 2>& contestant, const SegmentMix& mix)
      : contestant_(contestant), mix_(mix) {
    for (const SegmentBatch& batch : mix.batches) {
      projections_.push_back(projection_of<T>(batch.view));
      segments_.push_back(segments_cast<T>(batch.segments));
    }
  }

  double run() override { return run_share(share_); }

  void choose_share(double target_ns) override {
    const double count = static_cast<double>(mix_.size());
    const double least = std::min(1.0, kLeastSegments / count);
    share_ = std::clamp(target_ns / (run_share(least) * count), least, 1.0);
    run_share(share_);
  }

  std::string first_broken_promise(std::size_t limit) override {
    for (std::size_t b = 0; b < segments_.size(); ++b) {
      const std::size_t count =
          std::min(std::max<std::size_t>(1, limit / segments_.size()), segments_[b].size());
      const SegmentPromiseChecker checker(frustum_cast<double>(mix_.batches[b].view.frustum));
      out_.clear();
      contestant_.view(projections_[b], std::span(segments_[b]).first(count), out_);
      std::vector<PromiseCheck> checks(count);
      tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        checks[i] = checker.check<T, K>(contestant_.promise,
                                        input_segment(mix_.batches[b].segments[i]), K, out_[i]);
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
    for (std::size_t b = 0; b < segments_.size(); ++b) {
      const double wanted = std::ceil(share * static_cast<double>(segments_[b].size()));
      const std::size_t count = std::min(static_cast<std::size_t>(wanted), segments_[b].size());
      for (std::size_t first = 0; first < count; first += kBlock) {
        out_.clear();
        contestant_.view(projections_[b],
                         std::span(segments_[b]).subspan(first, std::min(kBlock, count - first)),
                         out_);
      }
      clipped += count;
    }
    const std::chrono::duration<double, std::nano> spent = Clock::now() - start;
    return spent.count() / static_cast<double>(clipped);
  }

  const Contestant<T, 2>& contestant_;
  const SegmentMix& mix_;
  std::vector<Projection<T>> projections_;
  std::vector<std::vector<ViewSegment<T, K>>> segments_;
  PolygonStream<T, K> out_;
  double share_ = 1.0;
};

std::unique_ptr<Runner> make_runner(const SegmentContestant& contestant, const SegmentMix& mix,
                                    double target_ns) {
  std::unique_ptr<Runner> runner = std::visit(
      [&]<class T>(const Contestant<T, 2>* c) -> std::unique_ptr<Runner> {
        return std::make_unique<RunnerOf<T>>(*c, mix);
      },
      contestant);
  runner->choose_share(target_ns);
  return runner;
}

}  // namespace

SegmentContestant segment_baseline() {
  return find_contestant<2>("homogeneous/cohen_sutherland", "float");
}

std::vector<Timing> measure_segment_time(const SegmentMix& mix,
                                         std::span<const SegmentContestant> contestants,
                                         const TimingOptions& options) {
  const double target_ns = options.milliseconds_per_run * 1e6;
  std::vector<Timing> timings(contestants.size());
  if (contestants.empty()) return timings;
  std::vector<std::unique_ptr<Runner>> runners;
  std::vector<std::size_t> timed;  // contestants, in the order of the tasks behind the baseline's
  runners.push_back(make_runner(segment_baseline(), mix, target_ns));
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    std::unique_ptr<Runner> runner = make_runner(contestants[i], mix, target_ns);
    timings[i].refused = runner->first_broken_promise(options.checked_triangles);
    if (!timings[i].refused.empty()) continue;
    runners.push_back(std::move(runner));
    timed.push_back(i);
  }
  std::vector<std::function<double()>> tasks;
  for (const auto& runner : runners) tasks.push_back([r = runner.get()] { return r->run(); });
  const std::vector<std::vector<double>> samples = run_in_turn(tasks, options.rounds);
  for (std::size_t task = 1; task < tasks.size(); ++task) {
    Timing& timing = timings[timed[task - 1]];
    timing.samples_ns = samples[task];
    timing.ns = median_interval(samples[task]);
    timing.speedup = median_interval(ratios(samples.front(), samples[task]));
  }
  return timings;
}

}  // namespace clipscope::experiments

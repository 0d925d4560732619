// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/segments/timing.hpp"

#include <memory>

#include "experiments/measure/timed_runs.hpp"
#include "experiments/segments/promise_check.hpp"

namespace clipscope::experiments {

SegmentContestant segment_baseline() {
  return find_contestant<2>("homogeneous/cohen_sutherland", "float");
}

std::vector<Timing> measure_segment_time(const SegmentMix& mix,
                                         std::span<const SegmentContestant> contestants,
                                         const TimingOptions& options) {
  if (contestants.empty()) return {};
  std::vector<RunBatch<2>> batches;
  for (const SegmentBatch& batch : mix.batches) batches.push_back({&batch.view, batch.segments});
  RunInputs<2> inputs(std::move(batches));

  const auto checks_in = [&mix]<class T>(TypeList<T>) {
    return [&mix](std::size_t b) {
      const SegmentBatch& batch = mix.batches[b];
      return [&batch, checker = SegmentPromiseChecker(frustum_cast<double>(batch.view.frustum))](
                 const Promise& promise, std::size_t i,
                 std::span<const NdcVertex<T, kSceneAttributes>> answer) {
        return checker.template check<T, kSceneAttributes>(
            promise, input_segment(batch.segments[i]), kSceneAttributes, answer);
      };
    };
  };
  const auto prepare = [&](const SegmentContestant& contestant) {
    return std::visit(
        [&]<class T>(const Contestant<T, 2>* c) {
          return make_timed_run(*c, inputs.template in<T>(), checks_in(TypeList<T>{}));
        },
        contestant);
  };
  return time_in_turn(
      prepare(segment_baseline()), contestants.size(),
      [&](std::size_t i) { return prepare(contestants[i]); }, options);
}

}  // namespace clipscope::experiments

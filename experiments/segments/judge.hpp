// SPDX-License-Identifier: GPL-3.0-or-later
//
// Line clippers against the exact answer, segment by segment.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "experiments/measure/compare.hpp"
#include "experiments/segments/timing.hpp"

namespace clipscope::experiments {

// Segments of one contestant on one mix.
struct SegmentTally {
  std::array<std::int64_t, kOutcomes> outcomes{};  // of those visible in truth or in the answer
  double max_px = 0;                               // over segments with the right vertices
  double max_ulp = 0;
  std::string worst;    // the segment with max_px, as hex floats behind its options
  std::string failing;  // the first segment with an outcome that is a failure in kind
  Outcome failing_outcome = Outcome::exact;

  std::int64_t visible() const;
  std::int64_t wrong() const;
  // "3 missing, 1 visible"; empty if none is wrong.
  std::string wrong_kinds() const;
};

// One tally per contestant, in their order, over at most `sample` evenly spaced segments of each batch.
// The same whatever the number of threads.
std::vector<SegmentTally> judge_segments(const SegmentMix& mix,
                                         std::span<const SegmentContestant> contestants,
                                         std::size_t sample);

// What `clipscope clip` needs to see the segment again: options, then its numbers.
std::string replay_text(const View& view, const SceneSegment& segment);

}  // namespace clipscope::experiments

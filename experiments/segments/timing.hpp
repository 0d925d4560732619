// SPDX-License-Identifier: GPL-3.0-or-later
//
// Timing of line clippers, as measure/timing.hpp does it for triangles.
//
// Answers are checked against the contestant's promise first: one that breaks it is not timed. Then the
// contestants run in turn on the same segments, and ratios refer to homogeneous/cohen_sutherland in
// float in the same round. Timed is the contract's whole way: view space in, NDC out.
#pragma once

#include <span>
#include <vector>

#include "experiments/measure/timing.hpp"
#include "experiments/segments/mixes.hpp"

namespace clipscope::experiments {

using SegmentContestant = AnyContestantOf<2>;

SegmentContestant segment_baseline();

// One timing per contestant, in their order, in ns per segment. Of the options checked_triangles counts
// segments. Pre-condition: the mix has a segment.
std::vector<Timing> measure_segment_time(const SegmentMix& mix,
                                         std::span<const SegmentContestant> contestants,
                                         const TimingOptions& options);

}  // namespace clipscope::experiments

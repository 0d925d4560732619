// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a clipper's time goes: transform, cut, divide.
//
// Three runs side by side, on the same triangles in the same rounds, each doing one step more:
//
//   view space   cut | cut and transform | all
//   clip space   transform | transform and cut | all
//   CVV          transform | transform and divide | all
//
// The transform alone is the three positions of every triangle to clip space (no attributes); transform
// and divide likewise. Runs up to a cut are the clipper itself in a scalar that leaves the rest out
// (staged.hpp). A part's time is the difference of two runs of the same round.
// Does not guarantee: that the parts are what the whole would spend. A processor overlaps one step with
// the next, which a run of the first alone can't; a part may then come out too small, even negative.
// The near cut of cvv/near_first is counted to the cut, though it comes before the divide. Clippers whose
// cut and divide are one pass (barycentric) or that do not cut (whole) have no split, nor have those of which
// the compiler makes slower code in the staged scalar (homogeneous/pipeline, homogeneous/blinn_newell).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/measure/statistics.hpp"
#include "experiments/measure/timing.hpp"

namespace clipscope::experiments {

struct SplitPart {
  std::string_view name;  // transform, cut, divide, in the order of the clipper; then whole
  MedianInterval ns;      // per triangle
  MedianInterval share;   // of the whole in the same round, percent
  std::vector<double> samples_ns;  // one per round
};

struct Split {
  std::string clipper, scalar;
  std::vector<SplitPart> parts;
};

// Those clippers that have steps, in float and double, if they are among the contestants.
// Contestants whose timing says `refused` are left out.
std::vector<Split> measure_split(std::span<const TimedBatch> batches,
                                 std::span<const AnyContestant> contestants,
                                 std::span<const Timing> timings, int rounds);

}  // namespace clipscope::experiments

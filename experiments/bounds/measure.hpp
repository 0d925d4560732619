// SPDX-License-Identifier: GPL-3.0-or-later
//
// One scene taken apart into objects, through all its views, by every kind of bounding volume.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/bounds/proof.hpp"
#include "experiments/contestants/contestant.hpp"
#include "experiments/measure/statistics.hpp"

namespace clipscope::experiments {

struct BoundsOptions {
  int rounds = 21;
  std::size_t judged_triangles = 0;  // of each view, by exact arithmetic; 0: all
};

struct BoundResult {
  std::string_view bound;
  CullTally tally;
  std::string difference;  // between polygons with and without; then nothing was timed
  std::vector<double> ns_without, ns_with;  // per triangle, one per round, over all views
  MedianInterval speedup;                   // of the same round
};

// One result per kind of volume that the objects allow, in the order of bound_kinds().
std::vector<BoundResult> measure_bounds(const ObjectScene& scene, const Contestant<float>& clipper,
                                        const BoundsOptions& options);

}  // namespace clipscope::experiments

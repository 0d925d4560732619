// SPDX-License-Identifier: GPL-3.0-or-later
//
// Time of planned pipelines beside the full one and beside transform and divide alone.
//
// All run in turn, round after round, in an order that rotates, on the same triangles in the mesh's
// order; a ratio compares runs of one round. Each clips all views, a small scene several times over.
// The thread is pinned where that is allowed. Pre-condition: answers were compared before (harm.hpp).
#pragma once

#include <span>
#include <vector>

#include "experiments/effects/planned_scene.hpp"
#include "experiments/measure/statistics.hpp"

namespace clipscope::experiments {

// ns per triangle, and ratios of rounds.
struct PlannedTiming {
  MedianInterval full_ns, planned_ns, bare_ns;  // bare: transform and divide alone, nothing clipped
  MedianInterval to_full, to_bare;              // planned to full, planned to bare
  MedianInterval facts_ns;                      // SceneFacts of each view
  MedianInterval attributes_ns;                 // AttributeFacts, once per mesh
  std::vector<double> full_samples, planned_samples, bare_samples;  // ns, one per round
};

struct PlannedTimingOptions {
  int rounds = 31;
  double milliseconds_per_run = 2;
};

// Pre-condition: there is a triangle.
PlannedTiming time_planned(std::span<const PlannedView> views, const PlannedTimingOptions& options);

}  // namespace clipscope::experiments

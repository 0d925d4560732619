// SPDX-License-Identifier: GPL-3.0-or-later
//
// The time of a geometry stage with a guard band against that of full clipping, on the same triangles in
// the same rounds.
//
// Both take view-space triangles and write NDC polygons one after the other, in float. What the
// rasterizer spends more is not in it: see BandTally.
// Every answer is checked before anything is timed: the polygon must lie on the triangle and cover
// all of it that is visible (PromiseChecker); with a band it may reach out of the volume.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "experiments/guard_band/band_clip.hpp"
#include "experiments/measure/statistics.hpp"
#include "experiments/measure/timing.hpp"

namespace clipscope::experiments {

struct BandTime {
  MedianInterval ns;               // per triangle
  MedianInterval speedup;          // full clipping's time over this one's, by rounds
  std::vector<double> samples_ns;  // one per round
  std::string refused;             // why nothing was timed; then the rest is empty
};

struct BandTimes {
  BandTime full;                // homogeneous/sutherland_hodgman
  BandTime scissored;           // homogeneous/guard_band: a band of 16, scissored in software
  std::vector<BandTime> bands;  // one for each band given
};

// Pre-condition: there is a triangle.
BandTimes time_bands(std::span<const TimedBatch> batches, std::span<const GuardBand> bands,
                     int rounds);

}  // namespace clipscope::experiments

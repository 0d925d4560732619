// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a guard band leaves to the rasterizer, and what it can't leave to it.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "experiments/guard_band/band_clip.hpp"
#include "experiments/measure/timing.hpp"
#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

inline constexpr double kNoSides = std::numeric_limits<double>::infinity();

// Of all triangles of some batches. Pixels are those of a 3840 x 2160 screen.
struct BandTally {
  std::int64_t triangles = 0, rejected = 0, side_cut = 0;
  std::int64_t polygons = 0, vertices = 0;
  // Pixels that a rasterizer looks at which goes through each fan triangle's bounding box, scissored
  // to the screen.
  double visited_px = 0;
  double area_px2 = 0;  // of the polygons, with what reaches beyond the screen

  std::int64_t passed() const { return triangles - rejected; }
  // Of the triangles that are not rejected, those that had to be cut at a side; 0 if there are none.
  double cut_percent() const;
};

BandTally tally_band(std::span<const TimedBatch> batches, const GuardBand& band);
// The same for full clipping: homogeneous/sutherland_hodgman in float. side_cut: those with a vertex
// outside a side of the volume after near and far have cut.
BandTally tally_full(std::span<const TimedBatch> batches);

// A rasterizer whose vertex coordinates are signed fixed-point numbers of so many integer bits, counted
// from the middle of a 3840 x 2160 screen.
struct FixedPoint {
  int integer_bits;

  double band_px() const;  // half width of what can be addressed
  GuardBand band() const;
  // Bits of an edge function (b - a) x (p - a) without overflow, at `subpixel_bits` per pixel: two
  // products of differences of two such numbers, subtracted.
  int edge_function_bits(int subpixel_bits) const;
};

// Points: does the full test draw other pixels than near and far alone with scissoring?
struct PointTally {
  std::int64_t points = 0, kept_full = 0, kept_near_far = 0;
  std::int64_t drawn = 0;   // by near and far alone, pixels on the screen
  std::int64_t differ = 0;  // points that one way draws and the other does not
};
// The triangles' vertices, in float.
PointTally tally_points(std::span<const TimedBatch> batches);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The geometry of OwnDriver: clips one primitive in homogeneous coordinates and puts it on the grid
// of the window.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "experiments/pixels/own_driver.hpp"

namespace clipscope::experiments {

// All that is linear in clip space.
struct OwnVertex {
  std::array<double, 4> position = {};
  std::array<double, 4> varying = {};
  std::array<double, 4> varying_w = {};  // times w: divided by w, what is linear in the window
  std::array<double, kMaxClipDistances> distances = {};
};

// Grid of the window: kGrid units to a px, whatever the sub-pixel bits.
inline constexpr std::int64_t kGrid = 512;
struct GridPoint {
  std::int64_t x = 0, y = 0;
};

struct OwnPolygon {
  std::vector<OwnVertex> vertices = {};  // 1 of a point, 2 of a line
  std::vector<GridPoint> grid = {};      // as many
  bool is_clipped = false;
};

// One primitive's vertices, unclipped and without places on the grid.
OwnPolygon own_polygon(const DrawCall& call, const std::vector<std::uint32_t>& numbers,
                       RasterFault fault);

// Cuts it at the depths and clip distances and, but for points, at a guard band. No vertices if
// nothing is left; w > 0 of those that are.
void clip_own(OwnPolygon& polygon, const DrawCall& call, RasterFault fault);

// Divides, and rounds to the nearest point that 2^bits to a px have.
void snap_own(OwnPolygon& polygon, const DrawCall& call, int bits, RasterFault fault);

}  // namespace clipscope::experiments

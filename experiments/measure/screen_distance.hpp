// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far apart two convex polygons are on screen, whatever their vertices: the Hausdorff distance.
//
// It is the largest distance from a point of one to the nearest point of the other, and is taken on at
// a vertex, since the distance to a convex set is convex. Computed in double: right to about 1e-9 of
// the polygons' size.
#pragma once

#include <span>

#include "experiments/measure/match.hpp"

namespace clipscope::experiments {

// In px. Where one polygon is empty, how far the other one reaches: the largest distance of two of its
// vertices; 0 if both are.
double screen_distance(std::span<const ScreenPoint> a, std::span<const ScreenPoint> b);

// The largest distance of two of the points; 0 for none.
double diameter(std::span<const ScreenPoint> points);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which vertex of an answer stands for which vertex of the exact polygon.
//
// Both are convex and wound alike, so that one rotation tells: the one that brings the vertices
// closest together on screen. Repeated vertices of an answer count once.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "experiments/judge/cycle.hpp"
#include "experiments/judge/outcome.hpp"

namespace clipscope::experiments {

using ScreenPoint = std::array<double, 2>;  // px, the origin in the middle

inline ScreenPoint screen_point(double x_ndc, double y_ndc) {
  return {x_ndc * kScreenWidth / 2, y_ndc * kScreenHeight / 2};
}

inline ScreenPoint screen_point(const VertexView& v) {
  return screen_point(v[0].value, v[1].value);
}

inline std::vector<ScreenPoint> screen_points(const std::vector<VertexView>& vertices) {
  std::vector<ScreenPoint> points;
  for (const VertexView& v : vertices) points.push_back(screen_point(v));
  return points;
}

// Where exact vertices are, from their numbers as doubles (TruthPolygon::approximation).
inline std::vector<ScreenPoint> screen_points(const std::vector<std::vector<double>>& vertices) {
  std::vector<ScreenPoint> points;
  for (const std::vector<double>& v : vertices) points.push_back(screen_point(v[0], v[1]));
  return points;
}

// The vertices but those at the place of the one before them.
inline std::vector<VertexView> distinct_vertices(const PolygonView& polygon) {
  constexpr std::size_t kPlace = 3;
  return without_repeats(polygon, [](const VertexView& a, const VertexView& b) {
    return same_vertex(a, b, kPlace, Likeness::by_value);
  });
}

// The r for which `from[i]` and `to[(i + r) % n]` belong together: the largest of their distances
// is the smallest. Pre-condition: as many in both.
inline std::size_t best_rotation(std::span<const ScreenPoint> from,
                                 std::span<const ScreenPoint> to) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t r = 0; r < from.size(); ++r) {
    double largest = 0;
    for (std::size_t i = 0; i < from.size() && largest < least; ++i) {
      const ScreenPoint& p = to[(i + r) % to.size()];
      largest = std::max(largest, std::hypot(p[0] - from[i][0], p[1] - from[i][1]));
    }
    if (largest < least) {
      least = largest;
      best = r;
    }
  }
  return best;
}

// How far apart two convex polygons are on screen, whatever their vertices, in px: the Hausdorff
// distance, the largest distance from a point of one to the nearest point of the other. It is taken
// on at a vertex, since the distance to a convex set is convex. Computed in double: right to about
// 1e-9 of the polygons' size. Where one polygon is empty, the diameter of the other; 0 if both are.
double screen_distance(std::span<const ScreenPoint> a, std::span<const ScreenPoint> b);

// The largest distance of two of the points; 0 for none.
double diameter(std::span<const ScreenPoint> points);

}  // namespace clipscope::experiments

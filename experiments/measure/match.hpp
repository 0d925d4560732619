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

#include "experiments/contestants/scalars.hpp"
#include "experiments/measure/outcome.hpp"

namespace clipscope::experiments {

using ScreenPoint = std::array<double, 2>;  // px, the origin in the middle

inline ScreenPoint screen_point(double x_ndc, double y_ndc) {
  return {x_ndc * kScreenWidth / 2, y_ndc * kScreenHeight / 2};
}

template <class T, int K>
ScreenPoint screen_point(const NdcVertex<T, K>& v) {
  return screen_point(nearest_double(v.position[0]), nearest_double(v.position[1]));
}

// The vertices but those that equal the one before them, in order, the last before the first.
template <class T, int K>
std::vector<const NdcVertex<T, K>*> distinct_vertices(std::span<const NdcVertex<T, K>> polygon) {
  const auto same = [](const NdcVertex<T, K>& a, const NdcVertex<T, K>& b) {
    return a.position[0] == b.position[0] && a.position[1] == b.position[1] &&
           a.position[2] == b.position[2];
  };
  std::vector<const NdcVertex<T, K>*> vertices;
  for (const NdcVertex<T, K>& v : polygon) {
    if (vertices.empty() || !same(v, *vertices.back())) vertices.push_back(&v);
  }
  while (vertices.size() > 1 && same(*vertices.front(), *vertices.back())) vertices.pop_back();
  return vertices;
}

// The r for which `from[i]` and `to[(i + r) % n]` belong together: the largest of their distances is
// the smallest. Pre-condition: as many in both.
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

}  // namespace clipscope::experiments

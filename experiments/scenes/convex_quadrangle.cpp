// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/convex_quadrangle.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace clipscope::experiments {
namespace {

using Point3 = std::array<double, 3>;

// Which way a -> b -> c turns in the plane of coordinates i and j: 1 or -1, or 0 where rounding
// leaves it open. Where no product underflows, the determinant of the rounded differences is off by
// less than (3 + 16 u) u (|left| + |right|), u = 2^-53.
int certain_turn(const Point3& a, const Point3& b, const Point3& c, std::size_t i, std::size_t j) {
  constexpr double kU = std::numeric_limits<double>::epsilon() / 2;
  constexpr double kSafelyNormal = 0x1p-960;
  const double left = (a[i] - c[i]) * (b[j] - c[j]), right = (a[j] - c[j]) * (b[i] - c[i]);
  const double size = std::abs(left) + std::abs(right), turn = left - right;
  if (!(size > kSafelyNormal) || !(std::abs(turn) > (3 + 16 * kU) * kU * size)) return 0;
  return turn > 0 ? 1 : -1;
}

}  // namespace

bool is_certainly_convex_quadrangle(std::span<const Point3> p) {
  if (p.size() != 4) return false;
  // The normal as the cross product of the diagonals, twice the area in each projection.
  std::array<double, 3> normal;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    normal[k] = std::abs((p[2][i] - p[0][i]) * (p[3][j] - p[1][j]) -
                         (p[2][j] - p[0][j]) * (p[3][i] - p[1][i]));
  }
  const auto k = static_cast<std::size_t>(std::ranges::max_element(normal) - normal.begin());
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  const int turn = certain_turn(p[0], p[1], p[2], i, j);
  // Four turns of less than half a circle, all the same way, make one circle and no more.
  return turn != 0 && certain_turn(p[1], p[2], p[3], i, j) == turn &&
         certain_turn(p[2], p[3], p[0], i, j) == turn &&
         certain_turn(p[3], p[0], p[1], i, j) == turn;
}

}  // namespace clipscope::experiments

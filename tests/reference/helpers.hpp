// SPDX-License-Identifier: GPL-3.0-or-later
//
// Literal triangles, and exact vertices in a form that can be compared and printed.
#pragma once

#include <algorithm>
#include <array>
#include <initializer_list>
#include <vector>

#include "reference/exact_clip.hpp"

namespace clipscope::reference {

using Position = std::array<double, 4>;

// Attribute 0, 1, 2 of vertex i is 1 where the index is i, else 0: the barycentric coordinates.
inline InputTriangle triangle(const Position& a, const Position& b, const Position& c) {
  InputTriangle r;
  r.attribute_count = 3;
  const std::array<Position, 3> positions = {a, b, c};
  for (int i = 0; i < 3; ++i) {
    r.vertices[i].position = positions[i];
    r.vertices[i].attributes[i] = 1;
  }
  return r;
}

inline Rational ratio(long numerator, long denominator) {
  const Rational n(numerator), d(denominator);
  return Rational(n / d);
}

// l = b = -1, r = t = 1, near 1, far 10, depth -1 to 1.
inline Frustum<double> unit_frustum() { return {}; }

}  // namespace clipscope::reference

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Linear algebra of four rows in exact numbers: products, ranks, and the point that three planes
// share.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "reference/fraction.hpp"
#include "spaces/projection.hpp"

namespace clipscope::experiments::camera {

using Rational = reference::Rational;
using Exact3 = std::array<Rational, 3>;
using Exact4 = std::array<Rational, 4>;
using ExactRows = std::array<Exact4, 4>;

// The rows' exact values. Pre-condition: they are finite.
ExactRows exact(const MatrixRows<double>& rows);

// The nearest double.
double to_double(const Rational& x);
Rational dot(const Exact3& a, const Exact3& b);
Rational dot(const Exact4& a, const Exact4& b);
// The first three.
Exact3 direction(const Exact4& v);
// a less its part along b. Pre-condition: b is not 0.
Exact3 without_part_along(const Exact3& a, const Exact3& b);

// Rounded to double from the exact sum of squares, and the direction of that length 1.
double length(const Exact3& v);
glm::dvec3 unit(const Exact3& v);

int rank(const ExactRows& rows);
// The point (x, y, z, w) that all three take to 0, up to a factor: the cross product in four
// dimensions. All 0 where they are dependent.
Exact4 common_point(const Exact4& a, const Exact4& b, const Exact4& c);
// A point that all rows take to 0: a direction (w = 0) with its largest entry 1, or (x, y, z, 1).
// Pre-condition: rank(rows) < 4.
std::array<double, 4> lost_point(const ExactRows& rows);

}  // namespace clipscope::experiments::camera

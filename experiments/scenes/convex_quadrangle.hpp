// SPDX-License-Identifier: GPL-3.0-or-later
//
// A quick test of polygons of four corners, the most frequent ones in mesh files: a convex one may
// be cut along either diagonal, and needs no triangulation.
//
// Source: Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
// Predicates", 1997: the error bound A of orient2d.
#pragma once

#include <array>
#include <span>

namespace clipscope::experiments {

// Whether the points are four, and their projection on the coordinate plane in which its area is
// about the largest turns strictly the same way at each. True is certain; false may also mean that
// rounding in double leaves it open.
bool is_certainly_convex_quadrangle(std::span<const std::array<double, 3>> points);

}  // namespace clipscope::experiments

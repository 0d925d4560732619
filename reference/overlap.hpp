// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a solid lies that need not be a polygon, the convex hull of some points or a sphere,
// relative to the intersection of half-spaces: without any rounding.
//
// Hull: it meets the half-spaces f_h >= 0 exactly if there are weights l_i >= 0 of its points with
// sum 1 and sum of l_i f_h(point i) >= 0 for all h. That is a linear program, solved by the simplex
// method in rational numbers with the rule that can't cycle: Bland, "New Finite Pivoting Rules for
// the Simplex Method", Mathematics of Operations Research 2(2), 1977.
//
// Sphere: the point of the half-spaces that is nearest to the centre is the foot of the
// perpendicular onto the intersection of at most three of their planes. Of all feet that lie in
// every half-space the nearest is it; its squared distance is rational.
//
// Guarantees: exact for every finite input. Solids and half-spaces are closed: what touches
// overlaps. It shares no code with what is tested by it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "reference/truth.hpp"

namespace clipscope::reference {

enum class Overlap {
  outside,  // no point in common
  inside,   // all of the solid is in every half-space
  across    // anything else
};

// A point of view space, or of the space that a matrix leads from.
using ExactPoint = std::array<Dyadic, 3>;

ExactPoint exact_point(double x, double y, double z);

std::vector<LinearForm> half_spaces_of(const Truth& truth);

// Of the convex hull. No point: outside. Takes time in proportion to the number of points, a few
// times over.
Overlap overlap(std::span<const LinearForm> half_spaces, std::span<const ExactPoint> points);

// Of the sphere. A negative radius: outside.
Overlap overlap(std::span<const LinearForm> half_spaces, const ExactPoint& centre,
                const Dyadic& radius);

}  // namespace clipscope::reference

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether given vertices are a planar convex polygon, decided exactly.
//
// Method: planar if all 3 x 3 minors of the differences to one vertex are 0; convex if each edge is
// a support line of the polygon. Quadratic in the number of vertices.
#pragma once

#include <span>

#include "reference/truth.hpp"

namespace clipscope::reference {

// Whether the vertices are, in this order, a convex polygon with an area: distinct, all in one
// plane (of R^3 or, in clip space, of R^4), and of either winding. Three successive vertices may
// lie on a line. Attributes must be affine over the polygon, else what they are within it is not
// defined.
// Pre-condition: is_finite(vertices, attribute_count).
bool is_planar_convex(std::span<const InputVertex> vertices, int attribute_count);

}  // namespace clipscope::reference

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The fast exact reference: the intersection of a triangle and the view volume, without any rounding.
//
// Method: Sutherland and Hodgman, "Reentrant Polygon Clipping", 1974, on barycentric coordinates. A
// vertex is lambda = (l0, l1, l2) >= 0 over the original triangle, not normalised; its signed distance
// to plane p is the sum of l_i d_p(vertex i). All of that are sums and products of dyadic numbers, so
// nothing is rounded and no gcd is taken; the only quotients are those of the result, left undone.
//
// Guarantees: exact for every finite input, whatever its exponents. It shares no code with the
// clippers. `classify` and `clip` may be called from many threads at once.
#pragma once

#include <vector>

#include "reference/fraction.hpp"
#include "reference/truth.hpp"

namespace clipscope::reference {

enum class Verdict {
  rejected,  // nothing of the triangle is in the volume
  accepted,  // all of it is
  clipped    // anything else
};

// A vertex in NDC, with its attributes as the true values at that point.
struct ExactVertex {
  Fraction x, y, z, inv_w;
  std::vector<Fraction> attributes;
};

// The closed intersection of triangle and volume: no vertex, one (the triangle touches the volume in
// a point), two (in a segment), or three to nine, in the winding of the input (more after an inset).
//
// No two vertices have the same x, y, z. If the triangle has an area in NDC the polygon is strictly
// convex. If it has none (three points on a line, or a plane through the eye in clip space), its
// vertices lie on a line, some perhaps between others, and of vertices that coincide the first stays.
struct ExactPolygon {
  Verdict verdict = Verdict::rejected;
  std::vector<ExactVertex> vertices;
};

// A vertex as rational numbers, for comparing with other exact computations; ordered by its members.
struct RationalVertex {
  Rational x, y, z, inv_w;
  std::vector<Rational> attributes;
};
bool operator==(const RationalVertex& a, const RationalVertex& b);
bool operator<(const RationalVertex& a, const RationalVertex& b);

// What the three vertices alone tell. `rejected`: all are outside of the same plane. `accepted`: all
// are inside, with w > 0. `clipped`: the triangle must be cut to know more; it may turn out empty.
// No arithmetic beyond doubles is done unless a vertex is within rounding of a plane.
// Pre-condition: is_finite(triangle).
Verdict classify(const Truth& truth, const InputTriangle& triangle);

// The verdict is `rejected` exactly if there are no vertices, and `accepted` as `classify` has it.
// Pre-condition: is_finite(triangle).
ExactPolygon clip(const Truth& truth, const InputTriangle& triangle);

// The polygon's vertices, sorted.
std::vector<RationalVertex> vertex_set(const ExactPolygon& polygon);

}  // namespace clipscope::reference

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The fast exact reference: the intersection of a primitive and the view volume, without any
// rounding.
//
// Primitives are points, segments, triangles and convex polygons: 1, 2, 3 and more vertices.
//
// Method: Sutherland and Hodgman, "Reentrant Polygon Clipping", 1974, on weights. A vertex is
// lambda = (l0, l1, ...) >= 0 over the vertices of the input (of a triangle: its barycentric
// coordinates), not normalised; its signed distance to plane p is the sum of l_i d_p(vertex i). All
// of that are sums and products of dyadic numbers, so nothing is rounded and no gcd is taken; the
// only quotients are those of the result, left undone.
//
// Guarantees: exact for every finite input, whatever its exponents. It shares no code with the
// clippers. `classify` and `clip` may be called from many threads at once.
#pragma once

#include <span>
#include <vector>

#include "reference/fraction.hpp"
#include "reference/truth.hpp"

namespace clipscope::reference {

enum class Verdict {
  rejected,  // nothing of the primitive is in the volume
  accepted,  // all of it is
  clipped    // anything else
};

// A vertex in NDC, with its attributes as the true values at that point.
struct ExactVertex {
  Fraction x, y, z, inv_w;
  std::vector<Fraction> attributes;
};

// The closure of what primitive and volume have in common.
//
// What is left of a primitive is
//
//   a point     itself or nothing
//   a segment   nothing, one vertex where it touches the volume, or two in the order of its ends
//   a triangle  no vertex, one where it touches the volume in a point, two in a segment, or three
//               to nine in the winding of the input; each half-space beyond the six may add one
//   a polygon   the same with as many vertices as it has to begin with
//
// No two vertices have the same x, y, z. If the primitive has an area in NDC the polygon is convex,
// strictly so if the input is. If it has none (three points on a line, or a plane through the eye
// in clip space), its vertices lie on a line, some perhaps between others, and of vertices that
// coincide the first stays.
//
// Vertices with w = 0 are left out, since they have no place in NDC. Where the volume asks for
// depth this loses nothing: only (0, 0, 0, 0) is inside it with w = 0. With depth clamp (0, 0, z,
// 0) is too, and a primitive that reaches it is unbounded in NDC: what remains are its finite
// vertices.
struct ExactPolygon {
  Verdict verdict = Verdict::rejected;
  std::vector<ExactVertex> vertices;
};

// A vertex as rational numbers, for comparing with other exact computations; ordered by its
// members.
struct RationalVertex {
  Rational x, y, z, inv_w;
  std::vector<Rational> attributes;
};
bool operator==(const RationalVertex& a, const RationalVertex& b);
bool operator<(const RationalVertex& a, const RationalVertex& b);

// What the vertices alone tell. `rejected`: all are outside of one plane, or on it if it is open.
// `accepted`: none is outside of any, and w > 0. `clipped`: the primitive must be cut to know more;
// it may turn out empty. No arithmetic beyond doubles is done unless a vertex is within rounding of
// a plane. Pre-conditions: those of `clip`.
Verdict classify(const Truth& truth, std::span<const InputVertex> vertices, int attribute_count);
Verdict classify(const Truth& truth, const InputTriangle& triangle);

// The verdict is `rejected` exactly if there are no vertices, and `accepted` as `classify` has it.
// Pre-conditions: at least one vertex; is_finite(vertices, attribute_count); attribute_count is at
// least the number of clip distances of the truth's volume; with more than three vertices
// is_planar_convex(vertices, attribute_count), see convex.hpp.
ExactPolygon clip(const Truth& truth, std::span<const InputVertex> vertices, int attribute_count);
ExactPolygon clip(const Truth& truth, const InputTriangle& triangle);

// The polygon's vertices, sorted.
std::vector<RationalVertex> vertex_set(const ExactPolygon& polygon);

}  // namespace clipscope::reference

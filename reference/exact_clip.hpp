// SPDX-License-Identifier: GPL-3.0-or-later
//
// DRAFT API: the fast exact reference.
#pragma once

#include <CGAL/Exact_rational.h>
#include <CGAL/Mpzf.h>

#include <array>
#include <vector>

#include "spaces/projection.hpp"

namespace clipscope::reference {

using Rational = CGAL::Exact_rational;
using Dyadic = CGAL::Mpzf;  // m 2^e: what floats, and sums and products of them, are

// An exact value that needs a division: numerator / denominator, not reduced, denominator > 0.
struct Fraction {
  Dyadic numerator, denominator;
};

// A triangle as given: float or double bits, all exactly doubles.
// position: view space (x, y, z, 1) or clip space (x, y, z, w).
struct InputVertex {
  std::array<double, 4> position{};
  std::array<double, kMaxAttributes> attributes{};
};
struct InputTriangle {
  std::array<InputVertex, 3> vertices;
  int attribute_count = 0;
};
template <Space S, class T, int K>
InputTriangle input_triangle(const Triangle<S, T, K>& triangle);

enum class TruthKind { frustum, matrix, clip };

// The volume and the projection, in exact numbers.
class Truth {
 public:
  static Truth of_frustum(const Frustum<double>& frustum);      // view space, exact frustum numbers
  static Truth of_matrix(const Projection<float>& projection);  // view space, the matrix as given
  static Truth of_matrix(const Projection<double>& projection);
  static Truth of_clip(DepthRange depth);                       // clip space
};

enum class Verdict { rejected, accepted, clipped };

struct ExactVertex {
  Fraction x, y, z, inv_w;
  std::vector<Fraction> attributes;
};

// The closed intersection of triangle and volume, distinct vertices in the triangle's winding: none,
// one (a point), two (a segment) or three to nine. Edges keep no vertex in their interior.
struct ExactPolygon {
  Verdict verdict;
  std::vector<ExactVertex> vertices;
};

}  // namespace clipscope::reference

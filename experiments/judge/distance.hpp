// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances from points to triangles and convex polygons in any dimension, squared, in any number
// type with +, -, *, / and an order: no square root is taken, so exact types stay exact.
//
// Source: Ericson, "Real-Time Collision Detection", 2005, section 5.1.5, with the Gram matrix of
// the two edges instead of cross products. Triangles may be degenerate.
#pragma once

#include <qd/qd_real.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "experiments/contestants/scalars.hpp"

namespace clipscope::experiments {

// A point or a direction. All points of one computation have the same dimension.
template <class N>
using Lifted = std::vector<N>;

template <class N>
Lifted<N> difference(const Lifted<N>& a, const Lifted<N>& b) {
  Lifted<N> d(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) d[i] = a[i] - b[i];
  return d;
}

template <class N>
N dot(const Lifted<N>& a, const Lifted<N>& b) {
  N sum(0);
  for (std::size_t i = 0; i < a.size(); ++i) sum = sum + N(a[i] * b[i]);
  return sum;
}

// Square of the distance from p to a + s ab + t ac.
template <class N>
N squared_distance(const Lifted<N>& ap, const Lifted<N>& ab, const Lifted<N>& ac, const N& s,
                   const N& t) {
  N sum(0);
  for (std::size_t i = 0; i < ap.size(); ++i) {
    const N d = ap[i] - s * ab[i] - t * ac[i];
    sum = sum + N(d * d);
  }
  return sum;
}

// The parameter in [0, 1] of the point of a segment nearest to p; `along` is its direction.
template <class N>
N nearest_on_segment(const Lifted<N>& start_to_p, const Lifted<N>& along) {
  const N length = dot(along, along);
  const N projected = dot(start_to_p, along);
  if (projected <= N(0) || length <= N(0)) return N(0);
  if (length <= projected) return N(1);
  return N(projected / length);
}

// Square of the distance from p to the triangle a b c, which may be degenerate.
template <class N>
N squared_distance_to_triangle(const Lifted<N>& p, const Lifted<N>& a, const Lifted<N>& b,
                               const Lifted<N>& c) {
  const Lifted<N> ab = difference(b, a), ac = difference(c, a), ap = difference(p, a);
  const N g11 = dot(ab, ab), g12 = dot(ab, ac), g22 = dot(ac, ac);
  const N h1 = dot(ap, ab), h2 = dot(ap, ac);
  const N determinant = g11 * g22 - g12 * g12;
  const N s = g22 * h1 - g12 * h2;
  const N t = g11 * h2 - g12 * h1;
  const N rest = determinant - s - t;
  const N on_ab = nearest_on_segment(ap, ab);
  const N on_ac = nearest_on_segment(ap, ac);
  const N on_bc = nearest_on_segment(difference(p, b), difference(c, b));
  const N d_ab = squared_distance(ap, ab, ac, on_ab, N(0));
  const N d_ac = squared_distance(ap, ab, ac, N(0), on_ac);
  const N d_bc = squared_distance(ap, ab, ac, N(N(1) - on_bc), on_bc);
  const N to_edges = std::min({d_ab, d_ac, d_bc});
  if (!(N(0) < determinant && N(0) <= s && N(0) <= t && N(0) <= rest)) return to_edges;
  // The foot of the perpendicular; in rounded arithmetic a needle's edges may be nearer than that.
  const N to_inside = squared_distance(ap, ab, ac, N(s / determinant), N(t / determinant));
  return std::min(to_inside, to_edges);
}

// Square of the distance from p to the convex polygon, as a fan.
template <class N>
N squared_distance_to_polygon(const Lifted<N>& p, const std::vector<Lifted<N>>& polygon) {
  N best = squared_distance_to_triangle(p, polygon[0], polygon[1], polygon[2]);
  for (std::size_t i = 3; i < polygon.size(); ++i) {
    const N d = squared_distance_to_triangle(p, polygon[0], polygon[i - 1], polygon[i]);
    if (d < best) best = d;
  }
  return best;
}

// The number type that distances between an answer and the truth are computed in: double-double
// for floats and doubles, quad-double for double-double, each much finer than the answer's scalar,
// and exact rationals for exact arithmetic.

inline double nearest_double(const qd_real& x) { return x[0] + x[1]; }

// The nearest double, then the nearest one to what is left, four times: an error of some 2^-212.
inline qd_real nearest_quad_double(const Exact& x) {
  qd_real sum(nearest_double(x));
  if (!std::isfinite(sum[0])) return sum;
  Exact rest = x - Exact(sum[0]);
  for (int i = 1; i < 4; ++i) {
    const double next = nearest_double(rest);
    sum += next;
    rest -= Exact(next);
  }
  return sum;
}

// Products of four coordinates neither over- nor underflow in a quad-double, nor do their errors.
inline bool fits_quad_double(double magnitude) { return magnitude > 1e-50 && magnitude < 1e50; }

// The value in N: exactly, or rounded to nearest with an error of some 2^-106 or 2^-212.
template <class N>
N distance_number(const Exact& x) {
  if constexpr (std::same_as<N, Exact>) {
    return x;
  } else if constexpr (std::same_as<N, qd_real>) {
    return nearest_quad_double(x);
  } else {
    return nearest_double_double(x);
  }
}

}  // namespace clipscope::experiments

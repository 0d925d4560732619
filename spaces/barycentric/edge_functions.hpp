// SPDX-License-Identifier: MIT
//
// Edge functions of a triangle in clip space: rasterising it without cutting it at the sides of the
// screen or at the eye.
//
// With the vertices (x_i, y_i, w_i) as columns of M, the point of the triangle seen at (X, Y) has
// the weights lambda_i with sum lambda_i (x_i, y_i, w_i) = w (X, Y, 1), so that
//
//   e = M^-1 (X, Y, 1)^T    has    e_i = lambda_i / w
//
// is linear on the screen. The point is inside the triangle and in front of the eye where all e_i
// >= 0 (0, on an edge, is inside), whatever the signs of the w_i; 1/w = sum e_i, z/w = sum e_i z_i
// and a/w = sum e_i a_i are linear as well.
// Source: Olano and Greer, "Triangle Scan Conversion using 2D Homogeneous Coordinates", Graphics
// Hardware 1997, equations 4 to 8.
// Does not guarantee: coverage to the last bit next to an edge (the adjugate is rounded), nor that
// the weights of a pixel on two edges agree; near and far are the caller's to test, per pixel.
#pragma once

#include <array>

#include "spaces/vertex.hpp"

namespace clipscope {

// a X + b Y + c, X and Y in NDC.
template <Scalar T>
struct ScreenPlane {
  T a, b, c;

  constexpr T at(const T& x, const T& y) const { return a * x + b * y + c; }
};

template <Scalar T>
struct EdgeFunctions {
  std::array<ScreenPlane<T>, 3> edges;  // e_i; all 0 where the triangle has no area on the screen

  // sum e_i value_i: the plane of value/w; of 1/w where all values are 1.
  constexpr ScreenPlane<T> over_w(const T& v0, const T& v1, const T& v2) const {
    const auto& [e, f, g] = edges;
    return {e.a * v0 + f.a * v1 + g.a * v2, e.b * v0 + f.b * v1 + g.b * v2,
            e.c * v0 + f.c * v1 + g.c * v2};
  }
};

namespace detail {

// The row of the adjugate that belongs to the vertex opposite of p-q: p x q over (x, y, w).
template <Scalar T>
constexpr ScreenPlane<T> cross_xyw(const Vec4<T>& p, const Vec4<T>& q) {
  return {p[1] * q[3] - p[3] * q[1], p[3] * q[0] - p[0] * q[3], p[0] * q[1] - p[1] * q[0]};
}

}  // namespace detail

// Pre-condition: finite positions.
template <Scalar T>
constexpr EdgeFunctions<T> edge_functions(const Vec4<T>& p0, const Vec4<T>& p1, const Vec4<T>& p2) {
  EdgeFunctions<T> r{
      {detail::cross_xyw(p1, p2), detail::cross_xyw(p2, p0), detail::cross_xyw(p0, p1)}};
  const ScreenPlane<T>& opposite = r.edges[0];
  const T det = p0[0] * opposite.a + p0[1] * opposite.b + p0[3] * opposite.c;
  for (ScreenPlane<T>& e : r.edges) {
    if (det == T(0)) {
      e = {T(0), T(0), T(0)};
    } else {
      e = {e.a / det, e.b / det, e.c / det};
    }
  }
  return r;
}

}  // namespace clipscope

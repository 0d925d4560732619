// SPDX-License-Identifier: MIT
//
// Sutherland-Hodgman's step: a convex polygon against one plane.
//
// Source: Sutherland and Hodgman, "Reentrant Polygon Clipping", CACM 17(1), 1974.
// Guarantees: the winding is kept; a vertex on the plane (d = 0) is kept and makes no second copy of
// itself; a new vertex is interpolated from the inside end of its edge towards the outside end, so
// that both neighbours of a shared edge compute the same bits from the same two vertices.
// Does not guarantee: that a new vertex lies on the plane, or that distances of later planes have the
// sign that exact arithmetic would give them: new vertices are rounded.
#pragma once

#include "spaces/polygon.hpp"

namespace clipscope {

// Writes to `out` the part of `in` with distance(v) >= 0. `meet(inside, outside, t)` makes the new
// vertex at t in (0, 1) from the inside end. `in` and `out` must differ.
template <Space S, Scalar T, int K, class Distance, class Meet>
constexpr void cut(const Polygon<S, T, K>& in, Polygon<S, T, K>& out, Distance&& distance,
                   Meet&& meet) {
  out.clear();
  const int n = in.size();
  if (n == 0) {
    return;
  }
  const T zero(0);
  int previous = n - 1;
  T d_previous = distance(in[previous]);
  for (int i = 0; i < n; ++i) {
    const T d = distance(in[i]);
    if (d < zero && zero < d_previous) {
      const T t = d_previous / (d_previous - d);
      out.push_back(meet(in[previous], in[i], t));
    } else if (d_previous < zero && zero < d) {
      const T t = d / (d - d_previous);
      out.push_back(meet(in[i], in[previous], t));
    }
    if (zero <= d) {
      out.push_back(in[i]);
    }
    previous = i;
    d_previous = d;
  }
}

// The same with linear interpolation of position and attributes.
template <Space S, Scalar T, int K, class Distance>
constexpr void cut(const Polygon<S, T, K>& in, Polygon<S, T, K>& out, Distance&& distance) {
  cut(in, out, distance, interpolate<S, T, K>);
}

}  // namespace clipscope

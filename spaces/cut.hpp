// SPDX-License-Identifier: MIT
//
// Sutherland-Hodgman's step: a convex polygon against one plane.
//
// A polygon is any list of vertices with size, [], clear and push_back: Polygon of fixed capacity
// or std::vector; the arithmetic is the same.
// Source: Sutherland and Hodgman, "Reentrant Polygon Clipping", CACM 17(1), 1974.
// Guarantees: the winding is kept; a vertex on the plane (d = 0) is kept and makes no second copy
// of itself; a new vertex is interpolated from the end of its edge that is nearer to the plane, the
// inside one of two equally near, so that both neighbours of a shared edge compute the same bits
// from the same two vertices. Near that end both t and what t is multiplied by are small, and hence
// what they add to the rounding of that end: t <= 1/2, and its product is off by 3 u t |b - a|.
// Does not guarantee: that a new vertex lies on the plane, or that distances of later planes have
// the sign that exact arithmetic would give them: new vertices are rounded.
#pragma once

#include <algorithm>
#include <bit>
#include <type_traits>
#include <utility>

#include "spaces/plane_segment.hpp"
#include "spaces/polygon.hpp"

namespace clipscope {

// The vertex type of a polygon.
template <class P>
using VertexOf = std::remove_cvref_t<decltype(std::declval<const P&>()[0])>;

// The scalar that a distance comes in.
template <class P, class Distance>
using ScalarOf = std::remove_cvref_t<std::invoke_result_t<Distance, const VertexOf<P>&>>;

// Writes to `out` the part of `in` with distance(v) >= 0. `meet(inside, outside, d_inside,
// d_outside)` makes the new vertex of an edge with d_inside > 0 > d_outside. `in` and `out` must
// differ.
template <class P, class Distance, class Meet>
constexpr void cut_by_distances(const P& in, P& out, Distance&& distance, Meet&& meet) {
  using T = ScalarOf<P, Distance>;
  out.clear();
  const auto n = in.size();
  if (n == 0) return;
  const T zero(0);
  auto previous = n - 1;
  T d_previous = distance(in[previous]);
  for (decltype(in.size()) i = 0; i < n; ++i) {
    const T d = distance(in[i]);
    if (d < zero && zero < d_previous) {
      out.push_back(meet(in[previous], in[i], d_previous, d));
    } else if (d_previous < zero && zero < d) {
      out.push_back(meet(in[i], in[previous], d, d_previous));
    }
    if (zero <= d) out.push_back(in[i]);
    previous = i;
    d_previous = d;
  }
}

// The point of an edge on the plane, made by meet(from, to, t): from the end nearer to the plane, t
// in (0, 1/2] of the way to the other. Which end that is can't be predicted, so it is chosen
// without a branch. Pre-condition: d_inside > 0 > d_outside.
// Source: S2 Geometry, s2edge_clipping.h (InterpolateDouble); Manifold's Interpolate.
template <class V, Scalar T, class Meet>
constexpr V from_nearer_end(const V& inside, const V& outside, const T& d_inside,
                            const T& d_outside, Meet&& meet) {
  const T beyond = -d_outside;
  const V* const ends[2] = {&inside, &outside};
  const int nearer = beyond < d_inside ? 1 : 0;
  const T length = d_inside - d_outside;
  const T t = std::min(d_inside, beyond) / length;
  return meet(*ends[nearer], *ends[1 - nearer], t);
}

// The same with linear interpolation of all that a vertex has.
template <class V, Scalar T>
constexpr V meeting(const V& inside, const V& outside, const T& d_inside, const T& d_outside) {
  return from_nearer_end(
      inside, outside, d_inside, d_outside,
      [](const V& from, const V& to, const T& t) { return interpolate(from, to, t); });
}

// Cuts where `meet(from, to, t)` makes the new vertex, from the end nearer to the plane.
template <class P, class Distance, class Meet>
constexpr void cut(const P& in, P& out, Distance&& distance, Meet&& meet) {
  using T = ScalarOf<P, Distance>;
  cut_by_distances(in, out, distance,
                   [&](const VertexOf<P>& inside, const VertexOf<P>& outside, const T& d_inside,
                       const T& d_outside) {
                     return from_nearer_end(inside, outside, d_inside, d_outside, meet);
                   });
}

// The same with linear interpolation.
template <class P, class Distance>
constexpr void cut(const P& in, P& out, Distance&& distance) {
  cut_by_distances(in, out, distance, meeting<VertexOf<P>, ScalarOf<P, Distance>>);
}

// step(plane, in, out) for each plane of the code, in the order of for_each_plane, to and fro
// between two lists; returns the one that holds the rest.
template <class P, class Step>
constexpr P& step_by_planes(P& polygon, P& scratch, Outcode planes,
                            const std::array<Plane, kPlanes>& order, Step&& step) {
  if (is_single(planes)) {
    step(static_cast<Plane>(std::countr_zero(planes)), polygon, scratch);
    return scratch;
  }
  P* in = &polygon;
  P* next = &scratch;
  // From one plane of the code to the next: which planes cut can't be predicted one by one.
  for (Outcode left = in_order(planes, order); left != 0; left &= left - 1) {
    step(plane_at(order, std::countr_zero(left)), *in, *next);
    std::swap(in, next);
  }
  return *in;
}

// Cuts by each plane of the code. distance(plane, v) is the signed distance.
template <class P, class Distance, class... Meet>
constexpr P& cut_by_planes(P& polygon, P& scratch, Outcode planes,
                           const std::array<Plane, kPlanes>& order, Distance&& distance,
                           const Meet&... meet) {
  return step_by_planes(polygon, scratch, planes, order, [&](Plane plane, const P& in, P& out) {
    cut(
        in, out, [&](const VertexOf<P>& v) { return distance(plane, v); }, meet...);
  });
}

// Cuts the polygon in place, unless all of it is inside.
template <class P, class Distance>
constexpr void cut_if_crossed(P& polygon, P& scratch, Distance&& distance) {
  using T = ScalarOf<P, Distance>;
  const bool inside = std::all_of(polygon.begin(), polygon.end(),
                                  [&](const VertexOf<P>& v) { return T(0) <= distance(v); });
  if (!inside) {
    scratch = polygon;
    cut(scratch, polygon, distance);
  }
}

}  // namespace clipscope

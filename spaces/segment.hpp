// SPDX-License-Identifier: MIT
//
// What the segment clippers share: the spaces that they clip in, and how their answer is written.
//
// A method (cohen_sutherland.hpp, liang_barsky.hpp, ...) is one source for every space. The space
// is a policy that knows its points and its planes; whether these are vertices in clip space,
// vertices in NDC or points of the plane, the method can't tell.
//
// The answer is a polygon of no or two vertices, in the order of the segment. A segment of which
// only one point remains is nothing.
#pragma once

#include <optional>

#include "spaces/clipper.hpp"
#include "spaces/plane_segment.hpp"

namespace clipscope {

template <class S>
using SegmentIn = std::array<typename S::PointType, 2>;

//   planes()                 the planes that clip
//   outcode(p)               the bits of those of them that p is outside of: by comparisons alone
//   distance(plane, p)       signed distance form: > 0 inside, < 0 outside; 0, on it, is inside
//   meet(plane, in, out, t)  the point at t from the inside end, on the plane to the last bit where
//                            the space can say so
template <class S>
concept SegmentSpace = requires(const S space, const typename S::PointType& p,
                                const typename S::ScalarType& t) {
  requires Scalar<typename S::ScalarType>;
  { space.planes() } -> std::same_as<Outcode>;
  { space.outcode(p) } -> std::same_as<Outcode>;
  { space.distance(Plane::left, p) } -> std::same_as<typename S::ScalarType>;
  { space.meet(Plane::left, p, p, t) } -> std::same_as<typename S::PointType>;
};

// A method for a space: what is left of a segment, in the order of the segment, or none.
template <class M, class S>
concept SegmentMethod = SegmentSpace<S> &&
    requires(const M method, const S& space, const SegmentIn<S>& segment) {
  { method(space, segment) } -> std::same_as<std::optional<SegmentIn<S>>>;
};

// Worst-case bounds of promises, in units of u M, as in clipper.hpp. One cut: 6 for t, 2 for b - a,
// 2 for its product with t, 1 for the sum, 3 for a view-space distance.
inline constexpr double kSegmentCutUlps = 14;
// A method that finds both ends from the original ones cuts each end once. Taking the wrong one of
// two planes costs as much as their parameters can differ then: comparing d0 / d1 of two planes by
// rounded products of rounded distances is wrong by 6 u at most, along an edge of at most 2 M.
inline constexpr double kParametricUlps = kSegmentCutUlps + 12;

// Whether two positions are equal in every coordinate.
template <class Position>
constexpr bool is_same_position(const Position& a, const Position& b) {
  for (int i = 0; i < Position::length(); ++i) {
    if (!(a[i] == b[i])) return false;
  }
  return true;
}

// Keeps a divided segment only if it is one: two vertices, finite (1/w may be infinite), and not
// the same. Two vertices that differ in 1/w alone are kept: rounding makes them of segments that
// point at the eye.
template <Scalar T, int K>
constexpr void keep_if_segment(NdcPolygon<T, K>& out) {
  clear_if_overflowed(out);
  if (out.size() != 2 || is_nan(out[0].position[3]) || is_nan(out[1].position[3]) ||
      is_same_position(out[0].position, out[1].position)) {
    out.clear();
  }
}

// The perspective divide of a clipped segment. What has w <= 0 after clipping has no picture: in
// exact arithmetic it is the point (0, 0, 0, 0), or (0, 0, z, 0) where depths do not clip.
template <Scalar T, int K>
constexpr void divide(const ClipSegment<T, K>& segment, NdcPolygon<T, K>& out) {
  out.clear();
  for (const ClipVertex<T, K>& v : segment) {
    const T& w = v.position[3];
    if (!(T(0) < w) || !is_finite(w)) {
      out.clear();
      return;
    }
    out.push_back(to_ndc(v));
  }
  keep_if_segment(out);
}

}  // namespace clipscope

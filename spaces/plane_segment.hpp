// SPDX-License-Identifier: MIT
//
// One segment against one plane: what is left of it, and the parameter of the cut.
//
// d is a signed distance form of the plane: > 0 inside, < 0 outside; 0, on the plane, is inside.
// The segment is cut at t = d_kept / (d_kept - d_cut), measured from the end that is kept (t = 0)
// towards the end that is cut away (t = 1), whichever of them comes first in the segment. So both
// directions of a segment give the same bits, and callers interpolate what they like:
// interpolate(kept, cut, t).
//
//   plane by point and normal  d = n . (x - p)         6 multiplications and 1 division when cut
//   plane of the clip volume   d = w + x and its kin   0 multiplications and 1 division when cut,
//                              the
//                                                      same for perspective, parallel and oblique
// and no division when nothing is cut.
//
// The denominator never vanishes: a cut needs d_kept > 0 > d_cut. That is so even where the plane's
// equation x / w = -1 has no solution, as on the segment from (-2, y, z, 3) to (4, y, z, -3).
// Source: the parametric form of Liang and Barsky, "A New Concept and Method for Line Clipping",
// ACM TOG 3(1), 1984; clip-space forms: Blinn and Newell, "Clipping Using Homogeneous Coordinates",
// 1978. Does not guarantee: 0 < t < 1 in rounded arithmetic: t may round to 0 or 1, and where
// d_kept - d_cut overflows it is 0 or NaN.
#pragma once

#include "spaces/planes.hpp"

namespace clipscope {

// Named by what happens to the segment's ends.
enum class SegmentSide : std::uint8_t {
  rejected,   // nothing longer than a point is inside; so too where a distance is NaN
  accepted,   // all of it is inside
  cut_first,  // the second end is kept
  cut_second  // the first end is kept
};

// d_first and d_second: signed distances of the two ends. Comparisons only.
template <Scalar T>
constexpr SegmentSide segment_side(const T& d_first, const T& d_second) {
  const T zero(0);
  if (d_second < zero && zero < d_first) return SegmentSide::cut_second;
  if (d_first < zero && zero < d_second) return SegmentSide::cut_first;
  if (zero <= d_first && zero <= d_second) return SegmentSide::accepted;
  return SegmentSide::rejected;
}

// The parameter of the cut, from the end that is kept. Pre-condition: d_kept > 0 > d_cut.
template <Scalar T>
constexpr T cut_parameter(const T& d_kept, const T& d_cut) {
  const T length = d_kept - d_cut;
  return d_kept / length;
}

template <Scalar T>
struct PlaneCut {
  SegmentSide side;
  T t;  // of the cut, from the kept end towards the one cut away; 0 where nothing is cut
};

template <Scalar T>
constexpr PlaneCut<T> cut_segment(const T& d_first, const T& d_second) {
  const SegmentSide side = segment_side(d_first, d_second);
  switch (side) {
    case SegmentSide::cut_first: return {side, cut_parameter(d_second, d_first)};
    case SegmentSide::cut_second: return {side, cut_parameter(d_first, d_second)};
    default: return {side, T(0)};
  }
}

// A plane through a point. The side that the normal points to is inside. The normal's length does
// not matter.
template <Scalar T>
struct PointNormalPlane {
  Vec3<T> point;
  Vec3<T> normal;
};

template <Scalar T>
constexpr T signed_distance(const PointNormalPlane<T>& plane, const Vec3<T>& v) {
  const T x = v[0] - plane.point[0];
  const T y = v[1] - plane.point[1];
  const T z = v[2] - plane.point[2];
  return plane.normal[0] * x + plane.normal[1] * y + plane.normal[2] * z;
}

template <Scalar T>
constexpr PlaneCut<T> cut_segment(const PointNormalPlane<T>& plane, const Vec3<T>& first,
                                  const Vec3<T>& second) {
  const T d_first = signed_distance(plane, first);
  const T d_second = signed_distance(plane, second);
  return cut_segment(d_first, d_second);
}

// A plane of the clip volume, in clip space or in NDC. A clip distance in NDC costs 2
// multiplications.
template <Space S, Scalar T, int K>
requires(S != Space::view) constexpr PlaneCut<T> cut_segment(DepthRange depth, Plane plane,
                                                             const Vertex<S, T, K>& first,
                                                             const Vertex<S, T, K>& second) {
  const T d_first = signed_distance(depth, plane, first);
  const T d_second = signed_distance(depth, plane, second);
  return cut_segment(d_first, d_second);
}

}  // namespace clipscope

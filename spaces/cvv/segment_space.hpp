// SPDX-License-Identifier: MIT
//
// The canonical view volume (CVV) as the segment clippers see it, after the divide.
//
// A new point gets the coordinate of its plane exactly (x = -1 on the left plane), as the published
// algorithms have it, and perspective-correct attributes.
// Source: Blinn, "Hyperbolic Interpolation", IEEE CG&A 12(4), 1992.
#pragma once

#include "spaces/cvv/sutherland_hodgman.hpp"
#include "spaces/homogeneous/segment_space.hpp"
#include "spaces/liang_barsky.hpp"

namespace clipscope {

template <Scalar T, int K>
class CvvSegmentSpace {
 public:
  using ScalarType = T;
  using PointType = NdcVertex<T, K>;

  explicit constexpr CvvSegmentSpace(const ClipVolume& volume)
      : volume_(volume), planes_(planes_of(volume)) {}

  constexpr Outcode planes() const { return planes_; }
  // A clip distance decides by the sign of the attribute, as in clip space. Pre-condition: w > 0.
  constexpr Outcode outcode(const NdcVertex<T, K>& v) const {
    return (ndc_outcode(volume_.depth, v.position) | clip_distance_outcode(volume_, v.attributes)) &
           planes_;
  }
  constexpr T distance(Plane plane, const NdcVertex<T, K>& v) const {
    return signed_distance(volume_.depth, plane, v);
  }
  constexpr NdcVertex<T, K> meet(Plane plane, const NdcVertex<T, K>& inside,
                                 const NdcVertex<T, K>& outside, const T& t) const {
    NdcVertex<T, K> r = cvv::interpolate_perspective(inside, outside, t);
    if (!is_clip_distance(plane)) r.position[static_cast<int>(plane) / 2] = coordinate(plane);
    return r;
  }

  // The coordinate that is the same everywhere on one of the six planes.
  constexpr T coordinate(Plane plane) const {
    switch (plane) {
      case Plane::left:
      case Plane::bottom: return T(-1);
      case Plane::near:
        if (volume_.depth == DepthRange::minus_one_to_one) return T(-1);
        return T(volume_.depth == DepthRange::reversed ? 1 : 0);
      case Plane::far: return T(volume_.depth == DepthRange::reversed ? 0 : 1);
      default: return T(1);
    }
  }

 private:
  ClipVolume volume_;
  Outcode planes_;
};

namespace cvv {

// Cuts a segment by the given planes in clip space and divides both ends. Nothing is left of it
// where an end has w <= 0 or is not finite after the cut.
template <Scalar T, int K>
constexpr std::optional<std::array<NdcVertex<T, K>, 2>> cut_and_divide(
    const ClipVolume& volume, Outcode planes, const ClipSegment<T, K>& segment) {
  const HomogeneousSegmentSpace<T, K> space(volume, planes);
  const std::optional<ClipSegment<T, K>> rest = LiangBarskyDivisionFree{}(space, segment);
  if (!rest || !has_finite_positions(*rest) || !(T(0) < (*rest)[0].position[3]) ||
      !(T(0) < (*rest)[1].position[3])) {
    return std::nullopt;
  }
  return std::array{to_ndc((*rest)[0]), to_ndc((*rest)[1])};
}

// Clips a divided segment by a method and writes what is left.
template <class Method, class S, Scalar T, int K>
constexpr void clip_divided(const S& space, const std::array<NdcVertex<T, K>, 2>& segment,
                            NdcPolygon<T, K>& out) {
  const std::optional<std::array<NdcVertex<T, K>, 2>> rest = Method{}(space, segment);
  out.clear();
  if (rest) {
    out.assign(*rest);
    keep_if_segment(out);
  }
}

}  // namespace cvv

// Cut by the near plane in clip space, divide, clip by a method in the CVV.
template <class Method>
struct NearCutThenCvv {
  template <Scalar T, int K>
  static constexpr void clip(const ClipVolume& volume, const ClipSegment<T, K>& segment,
                             NdcPolygon<T, K>& out) {
    const auto divided = cvv::cut_and_divide(volume, bit(Plane::near), segment);
    out.clear();
    if (divided) cvv::clip_divided<Method>(CvvSegmentSpace<T, K>(volume), *divided, out);
  }
};

// Divide whatever w is, clip by a method in the CVV.
template <class Method>
struct DivideThenCvv {
  template <Scalar T, int K>
  static constexpr void clip(const ClipVolume& volume, const ClipSegment<T, K>& segment,
                             NdcPolygon<T, K>& out) {
    out.clear();
    if (!has_finite_positions(segment)) return;
    for (const ClipVertex<T, K>& v : segment) {
      if (!can_divide_by(v.position[3])) return;
    }
    const std::array<NdcVertex<T, K>, 2> divided = {to_ndc(segment[0]), to_ndc(segment[1])};
    cvv::clip_divided<Method>(CvvSegmentSpace<T, K>(volume), divided, out);
  }
};

}  // namespace clipscope

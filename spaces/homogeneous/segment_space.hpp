// SPDX-License-Identifier: MIT
//
// Clip space as the segment clippers see it: 6-bit outcodes, planes w + x >= 0 and their kin.
//
// Source: Blinn and Newell, "Clipping Using Homogeneous Coordinates", SIGGRAPH 1978.
#pragma once

#include "spaces/segment.hpp"

namespace clipscope {

template <Scalar T, int K>
class HomogeneousSegmentSpace {
 public:
  using ScalarType = T;
  using PointType = ClipVertex<T, K>;

  // `among`: only these of the volume's planes clip.
  explicit constexpr HomogeneousSegmentSpace(const ClipVolume& volume, Outcode among = ~Outcode{0})
      : volume_(volume), planes_(planes_of(volume) & among) {}

  constexpr Outcode planes() const { return planes_; }
  constexpr Outcode outcode(const ClipVertex<T, K>& v) const {
    return (clip_outcode(volume_.depth, v.position) |
            clip_distance_outcode(volume_, v.attributes)) &
           planes_;
  }
  constexpr T distance(Plane plane, const ClipVertex<T, K>& v) const {
    return signed_distance(volume_.depth, plane, v);
  }
  // Not moved onto the plane to the last bit: so a segment gets the bits of a polygon's edge.
  constexpr ClipVertex<T, K> meet(Plane, const ClipVertex<T, K>& inside,
                                  const ClipVertex<T, K>& outside, const T& t) const {
    return interpolate(inside, outside, t);
  }

 private:
  ClipVolume volume_;
  Outcode planes_;
};

// Clip by a method in clip space, then divide.
template <class Method>
struct ClipSegmentThenDivide {
  template <Scalar T, int K>
  static constexpr void clip(const ClipVolume& volume, const ClipSegment<T, K>& segment,
                             NdcPolygon<T, K>& out) {
    const HomogeneousSegmentSpace<T, K> space(volume);
    const std::optional<ClipSegment<T, K>> rest = Method{}(space, segment);
    if (rest) {
      divide(*rest, out);
    } else {
      out.clear();
    }
  }
};

}  // namespace clipscope

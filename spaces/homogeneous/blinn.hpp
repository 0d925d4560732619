// SPDX-License-Identifier: MIT
//
// Blinn's line clipper: boundary coordinates of both ends, outcodes from their signs, and a
// parameter for those planes only that one end is outside of.
//
// A boundary coordinate is the signed distance to a plane, w + x and its kin. The bits of those
// that are negative make the outcode of an end. Codes with a bit in common reject, codes without a
// bit accept: so far Cohen and Sutherland. For each bit that remains the parameter alpha where the
// plane is met comes from the two boundary coordinates that are there already, the largest alpha
// bounds the first end, the smallest the second, and both ends are made once, from the original
// ones: Cyrus and Beck's part.
// Source: Blinn, "A Trip Down the Graphics Pipeline: Line Clipping", IEEE CG&A 11(1), 1991, as
// described in Agoston, "Computer Graphics and Geometric Modeling: Implementation and Algorithms",
// 2005.
// What the contract adds: alpha is measured from the end that is kept (parametric_bounds.hpp),
// where Blinn measures both from the first end.
// Guarantees: no division to accept or reject by outcodes, one for each plane between the ends. A
// segment and its reverse give the same bits.
// Does not guarantee: coordinates within the volume to the last bit after the divide.
#pragma once

#include "spaces/homogeneous/segment_space.hpp"
#include "spaces/parametric_bounds.hpp"

namespace clipscope {

struct BlinnLines {
  // The part of the segment that is inside, or none.
  template <SegmentSpace S>
  constexpr std::optional<SegmentIn<S>> operator()(const S& space,
                                                   const SegmentIn<S>& segment) const {
    const Bounded<S> first(space, segment[0]);
    const Bounded<S> second(space, segment[1]);
    if ((first.code & second.code) != 0) return std::nullopt;
    if ((first.code | second.code) == 0) return segment;
    ParametricBounds<typename S::ScalarType> bounds;
    bool visible = true;
    for_each_plane(first.code | second.code, kAllPlanes, [&](Plane plane) {
      if (visible) visible = bounds.cut(plane, first[plane], second[plane]);
    });
    if (!visible) return std::nullopt;
    return bounds.move_ends(space, segment);
  }

 private:
  // The boundary coordinates of an end, and its outcode: a bit for each that is not >= 0.
  template <SegmentSpace S>
  struct Bounded {
    using T = typename S::ScalarType;

    std::array<T, kMaxPlanes> coordinates;  // of the planes that clip
    Outcode code = 0;

    constexpr Bounded(const S& space, const typename S::PointType& p) {
      for_each_plane(space.planes(), kAllPlanes, [&](Plane plane) {
        T& d = coordinates[static_cast<std::size_t>(plane)];
        d = space.distance(plane, p);
        if (!(T(0) <= d)) code |= bit(plane);
      });
    }
    constexpr const T& operator[](Plane plane) const {
      return coordinates[static_cast<std::size_t>(plane)];
    }
  };
};

struct HomogeneousBlinn : StartsInClipSpace<ClipSegmentThenDivide<BlinnLines>> {
  static constexpr std::string_view name = "homogeneous/blinn";
  static constexpr std::string_view summary =
      "boundary coordinates in clip space: outcodes by their signs, parameters by their values";
  static constexpr std::string_view source =
      "Blinn, A Trip Down the Graphics Pipeline: Line Clipping, 1991";
  static constexpr Promise promise{.ulps = kProjectUlps + kParametricUlps, .watertight = true};
};

}  // namespace clipscope

// SPDX-License-Identifier: MIT
//
// Cyrus and Beck's segment clipper, for every space.
//
// Every plane of a convex volume gives the parameter where the segment's line crosses it; the
// largest of those where it enters and the smallest of those where it leaves bound what is visible.
// All planes are visited and divided for; whether anything is visible is asked once, at the end.
// In a space whose planes are constants (clip space, the CVV) the normals and offsets that the
// paper computes once per window are constants as well, and nothing is left to be computed before.
// Source: Cyrus and Beck, "Generalized Two- and Three-Dimensional Clipping", Computers & Graphics
// 3(1), 1978.
// Guarantees: a segment and its reverse give the same bits: see parametric_bounds.hpp.
#pragma once

#include "spaces/parametric_bounds.hpp"

namespace clipscope {

struct CyrusBeck {
  // The part of the segment that is inside, or none.
  template <SegmentSpace S>
  constexpr std::optional<SegmentIn<S>> operator()(const S& space,
                                                   const SegmentIn<S>& segment) const {
    ParametricBounds<typename S::ScalarType> bounds;
    bool visible = true;
    for_each_plane(space.planes(), kAllPlanes, [&](Plane plane) {
      const bool left =
          bounds.cut(plane, space.distance(plane, segment[0]), space.distance(plane, segment[1]));
      visible = visible && left;
    });
    if (!visible) return std::nullopt;
    return bounds.move_ends(space, segment);
  }
};

}  // namespace clipscope

// SPDX-License-Identifier: MIT
//
// Pruning: a segment's ends are cut back by each plane in turn, for every space.
//
// An end outside of a plane moves to where the segment, as it is by then, meets the plane. Both
// ends of a segment that is outside of a plane would move to the same point, and that they coincide
// in the end is how the paper knows it, up to a tolerance.
// Source: Wijeweera and Kodituwakku, "An Approach for Line Clipping against a Convex Polyhedron",
// Ruhuna Journal of Science 7(1), 2016, by its abstract, which leaves the order of the planes open;
// in the plane: Wijeweera, Kodituwakku and Chamikara, "A Novel and Efficient Approach for Line
// Segment Clipping Against a Convex Polygon", Ruhuna Journal of Science 10(2), 2019.
// What is mended: a segment whose ends coincide has no line any more, so a segment outside of a
// plane is nothing at once, and no tolerance is needed.
// Guarantees: a segment and its reverse give the same bits: one end at most is cut by a plane, and
// its parameter is measured from the other.
// Does not guarantee: one cut for each end: what one plane shortened the next may shorten again.
#pragma once

#include "spaces/segment.hpp"

namespace clipscope {

// Cuts the segment back by one plane. Returns whether more than a point is left.
template <class S, class PlaneId, class Point>
constexpr bool prune(const S& space, PlaneId plane, std::array<Point, 2>& ends) {
  const auto cut = cut_segment(space.distance(plane, ends[0]), space.distance(plane, ends[1]));
  if (cut.side == SegmentSide::accepted) return true;
  using T = std::remove_cvref_t<decltype(cut.t)>;
  if (cut.side == SegmentSide::rejected || !(T(0) < cut.t)) return false;
  const std::size_t moved = cut.side == SegmentSide::cut_first ? 0 : 1;
  ends[moved] = space.meet(plane, ends[1 - moved], ends[moved], cut.t);
  return true;
}

struct Pruning {
  // The part of the segment that is inside, or none.
  template <SegmentSpace S>
  constexpr std::optional<SegmentIn<S>> operator()(const S& space,
                                                   const SegmentIn<S>& segment) const {
    SegmentIn<S> ends = segment;
    bool visible = true;
    for_each_plane(space.planes(), kAllPlanes, [&](Plane plane) {
      if (visible) visible = prune(space, plane, ends);
    });
    if (!visible) return std::nullopt;
    return ends;
  }
};

}  // namespace clipscope

// SPDX-License-Identifier: MIT
//
// The ends of a segment as methods move them that compute coordinates of the plane themselves.
//
// Such a method sees x and y alone. A point of the plane is done with that; what else a vertex has
// (depth, 1/w, attributes) gets a parameter of its own, where the segment crosses the side that the
// end was moved to last.
#pragma once

#include "spaces/window/rectangle.hpp"

namespace clipscope {

template <Scalar T>
struct PlanarEnd {
  Vec2<T> at;
  bool is_moved = false;
  Plane side = Plane::left;  // that it was moved to last

  // To the place on a side that has the other coordinate `along`.
  constexpr void move(Plane to, const T& coordinate, const T& along) {
    at[side_axis(to)] = coordinate;
    at[1 - side_axis(to)] = along;
    is_moved = true;
    side = to;
  }
};

template <PlanarSpace S>
constexpr std::array<PlanarEnd<typename S::ScalarType>, 2> planar_ends(
    const S& space, const SegmentIn<S>& segment) {
  const auto& p = space.position(segment[0]);
  const auto& q = space.position(segment[1]);
  return {{{{p[0], p[1]}}, {{q[0], q[1]}}}};
}

// Whether both points are outside of one side.
template <Scalar T>
constexpr bool share_outside(const Rectangle<T>& r, const Vec2<T>& p, const Vec2<T>& q) {
  return (p[0] < r.left && q[0] < r.left) || (r.right < p[0] && r.right < q[0]) ||
         (p[1] < r.bottom && q[1] < r.bottom) || (r.top < p[1] && r.top < q[1]);
}

// The segment with its moved ends.
template <PlanarSpace S>
constexpr SegmentIn<S> place_ends(const S& space, const SegmentIn<S>& segment,
                                  const std::array<PlanarEnd<typename S::ScalarType>, 2>& ends) {
  SegmentIn<S> placed = segment;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!ends[i].is_moved) continue;
    placed[i] = space.meet_at(ends[i].side, segment[1 - i], segment[i], ends[i].at);
  }
  return placed;
}

}  // namespace clipscope

// SPDX-License-Identifier: MIT
//
// Matthes and Drakopoulos's segment clipper: in the plane, and as a clipper in the window.
//
// After the test whether both ends are outside of one side, an end beyond the left or right side
// moves there along the line through the original ends, and then, if it is beyond the bottom or top
// side, it moves there along the same line. No outcodes: each comparison is made where it is
// needed. Both ends of a line that misses the window come to rest at the same place beyond a
// corner, outside of the left or the right side, which rejects it.
// Source: Matthes and Drakopoulos, "Another Simple but Faster Method for 2D Line Clipping",
// International Journal of Computer Graphics & Animation 9(1/2/3), 2019; by the abstract and two
// public implementations that follow the paper closely and agree. Its slope is divided for each
// move, as there.
// Guarantees: no division by zero: an end that moves to a side has the other end inside of it or on
// it. No new point lies outside the side that made it last.
// Does not guarantee: the same bits for a segment and its reverse: both ends are computed from the
// first. (The clipper:) an answer where w <= 0 is left after the cut by near and far.
#pragma once

#include "spaces/window/planar_ends.hpp"
#include "spaces/window/segment_steps.hpp"

namespace clipscope {

struct MatthesDrakopoulos {
  // The part of the segment that is inside, or none.
  template <PlanarSpace S>
  constexpr std::optional<SegmentIn<S>> operator()(const S& space,
                                                   const SegmentIn<S>& segment) const {
    using T = typename S::ScalarType;
    const Rectangle<T>& r = space.rectangle();
    std::array<PlanarEnd<T>, 2> ends = planar_ends(space, segment);
    const Vec2<T> p = ends[0].at;
    const Vec2<T> q = ends[1].at;
    if (share_outside(r, p, q)) return std::nullopt;
    for (PlanarEnd<T>& end : ends) {
      if (end.at[0] < r.left) {
        move<0>(end, Plane::left, r.left, p, q);
      } else if (r.right < end.at[0]) {
        move<0>(end, Plane::right, r.right, p, q);
      }
      if (end.at[1] < r.bottom) {
        move<1>(end, Plane::bottom, r.bottom, p, q);
      } else if (r.top < end.at[1]) {
        move<1>(end, Plane::top, r.top, p, q);
      }
    }
    const T& x = ends[0].at[0];
    const T& z = ends[1].at[0];
    if ((x < r.left && z < r.left) || (r.right < x && r.right < z)) return std::nullopt;
    return place_ends(space, segment, ends);
  }

 private:
  // y = (q.y - p.y) / (q.x - p.x) * (side - p.x) + p.y, and likewise for x.
  template <int kAxis, Scalar T>
  static constexpr void move(PlanarEnd<T>& end, Plane side, const T& coordinate, const Vec2<T>& p,
                             const Vec2<T>& q) {
    constexpr int kAlong = 1 - kAxis;
    const T rise = q[kAlong] - p[kAlong];
    const T run = q[kAxis] - p[kAxis];
    const T slope = rise / run;
    const T along = slope * (coordinate - p[kAxis]) + p[kAlong];
    end.move(side, coordinate, along);
  }
};

namespace window {

template <Scalar T>
constexpr std::optional<Segment2<T>> matthes_drakopoulos(const Rectangle<T>& rectangle,
                                                         const Segment2<T>& segment) {
  return clip(MatthesDrakopoulos{}, rectangle, segment);
}

}  // namespace window

struct WindowMatthesDrakopoulos : StartsInClipSpace<DepthCutThenWindow<MatthesDrakopoulos>> {
  static constexpr std::string_view name = "window/matthes_drakopoulos";
  static constexpr std::string_view summary =
      "near and far cut in clip space, divide, then Matthes and Drakopoulos's slopes in 2D";
  static constexpr std::string_view source =
      "Matthes and Drakopoulos, Another Simple but Faster Method for 2D Line Clipping, 2019";
  // The slope form rounds a new coordinate as often as a cut by its parameter.
  static constexpr Promise promise = window_promise(kParametricUlps, false);
};

}  // namespace clipscope

// SPDX-License-Identifier: MIT
//
// Ray's segment clipper: in the plane, and as a clipper in the window.
//
// After the test whether both ends are outside of one side, an end beyond the left or right side is
// to move there if the line passes between the corners of that side, that is, if these lie on
// different sides of the line: the product of two determinants is not positive. Else, if it is
// beyond the bottom or top side, the same is asked of that side. An outside end that no side takes
// rejects the segment. Nothing is divided but for the intersections of the answer.
// Source: Ray, "A Line Segment Clipping Algorithm in 2D", International Journal of Computer
// Graphics 3(2), 2012; by a public implementation that follows it (Zabolotny, Yet Another Graphics
// Library, 2014). Its separate horizontal and vertical lines are no cases here: nothing is divided
// by 0 without them. What its determinants and the intersection share is computed once.
// Guarantees: one division for each end that is moved, and none to accept or to reject.
// Does not guarantee: an answer where the product of two determinants leaves the scalar's range;
// the same bits for a segment and its reverse where a - b and b - a differ by more than the sign,
// as in double-double. (The clipper:) an answer where w <= 0 is left after the cut by near and far.
#pragma once

#include "spaces/window/planar_ends.hpp"
#include "spaces/window/segment_steps.hpp"

namespace clipscope {

struct RayCorners {
  // The part of the segment that is inside, or none.
  template <PlanarSpace S>
  constexpr std::optional<SegmentIn<S>> operator()(const S& space,
                                                   const SegmentIn<S>& segment) const {
    using T = typename S::ScalarType;
    const Rectangle<T>& r = space.rectangle();
    std::array<PlanarEnd<T>, 2> ends = planar_ends(space, segment);
    if (share_outside(r, ends[0].at, ends[1].at)) return std::nullopt;
    const Vec2<T> d(ends[1].at[0] - ends[0].at[0], ends[1].at[1] - ends[0].at[1]);
    if (!come_in(r, d, ends[0]) || !come_in(r, d, ends[1])) return std::nullopt;
    return place_ends(space, segment, ends);
  }

 private:
  // Whether the end is inside, or was moved to where the line comes in.
  template <Scalar T>
  static constexpr bool come_in(const Rectangle<T>& r, const Vec2<T>& d, PlanarEnd<T>& end) {
    const Vec2<T>& p = end.at;
    if (r.left <= p[0] && p[0] <= r.right && r.bottom <= p[1] && p[1] <= r.top) return true;
    if (p[0] < r.left) {
      if (enters_by<0>(d, Plane::left, r.left, r.bottom, r.top, end)) return true;
    } else if (r.right < p[0]) {
      if (enters_by<0>(d, Plane::right, r.right, r.bottom, r.top, end)) return true;
    }
    if (p[1] < r.bottom) return enters_by<1>(d, Plane::bottom, r.bottom, r.left, r.right, end);
    if (r.top < p[1]) return enters_by<1>(d, Plane::top, r.top, r.left, r.right, end);
    return false;
  }

  // Moves the end to the side if the line passes between its corners; `low` and `high` are their
  // other coordinates.
  template <int kAxis, Scalar T>
  static constexpr bool enters_by(const Vec2<T>& d, Plane side, const T& coordinate, const T& low,
                                  const T& high, PlanarEnd<T>& end) {
    constexpr int kAlong = 1 - kAxis;
    const T across = coordinate - end.at[kAxis];
    const T rise = across * d[kAlong];
    const T first = d[kAxis] * (low - end.at[kAlong]) - rise;
    const T second = d[kAxis] * (high - end.at[kAlong]) - rise;
    const T product = first * second;
    if (!(product <= T(0))) return false;
    const T along = end.at[kAlong] + rise / d[kAxis];
    end.move(side, coordinate, along);
    return true;
  }
};

namespace window {

template <Scalar T>
constexpr std::optional<Segment2<T>> ray(const Rectangle<T>& rectangle,
                                         const Segment2<T>& segment) {
  return clip(RayCorners{}, rectangle, segment);
}

}  // namespace window

struct WindowRay : StartsInClipSpace<DepthCutThenWindow<RayCorners>> {
  static constexpr std::string_view name = "window/ray";
  static constexpr std::string_view summary =
      "near and far cut in clip space, divide, then Ray's test of the corners of a side in 2D";
  static constexpr std::string_view source = "Ray, A Line Segment Clipping Algorithm in 2D, 2012";
  // A determinant decides wrongly of a corner that is at most 12 u M from the line, along the side.
  static constexpr Promise promise = window_promise(kParametricUlps, false);
};

}  // namespace clipscope

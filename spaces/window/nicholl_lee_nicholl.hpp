// SPDX-License-Identifier: MIT
//
// Nicholl, Lee and Nicholl's segment clipper: in the plane, and as a clipper in the window.
//
// Where the first end lies (inside, beyond one side, beyond a corner) and where the second end lies
// as seen from there, between the lines to the corners, names the sides that are crossed before any
// intersection is computed. The symmetric cases are one case here, written for the sides that the
// ends are beyond instead of for left and top. On which side of a corner the second end lies is the
// sign of the determinant of distances in binding_plane.hpp.
// Source: Nicholl, Lee and Nicholl, "An Efficient New Algorithm for 2-D Line Clipping: Its
// Development and Analysis", SIGGRAPH 1987.
// Guarantees: no division but one for each end that is moved, and no comparison of sides that the
// segment can't cross.
// Does not guarantee: the same answer for a segment and its reverse where it passes within rounding
// of a corner: the two ask about different corners. (The clipper:) an answer where w <= 0 is left
// after the cut by near and far.
#pragma once

#include <bit>

#include "spaces/binding_plane.hpp"
#include "spaces/window/segment_steps.hpp"

namespace clipscope {

struct NichollLeeNicholl {
  // The part of the segment that is inside, or none. Only for spaces whose planes are the four
  // sides.
  template <SegmentSpace S>
  constexpr std::optional<SegmentIn<S>> operator()(const S& space,
                                                   const SegmentIn<S>& segment) const {
    return Walk<S>{space, segment}.clip();
  }

 private:
  template <class S>
  struct Walk {
    using Binding = BindingPlane<typename S::ScalarType>;

    // The sides that an end is beyond, one of left and right and one of bottom and top at most.
    struct Region {
      Binding x, y;
      bool missed = false;  // the other end does not come inside of them
    };

    const S& space;
    const SegmentIn<S>& segment;

    constexpr std::optional<SegmentIn<S>> clip() const {
      const Outcode first = space.outcode(segment[0]);
      const Outcode second = space.outcode(segment[1]);
      if ((first & second) != 0) return std::nullopt;
      const Region from = region(first, 0);
      const Region to = region(second, 1);
      if (from.missed || to.missed) return std::nullopt;
      // From beyond a corner the segment comes in by the side that it crosses later. It can miss
      // the window then only by crossing one of the other axis's sides too early: the opposite side
      // of its own axis comes after.
      const Binding in = tighter(from.x, from.y);
      const bool in_by_x = from.x.binds && in.plane == from.x.plane;
      if (!is_visible(in, in_by_x ? to.y : to.x)) return std::nullopt;
      return move_ends(space, segment, in, tighter(to.x, to.y));
    }

    constexpr Region region(Outcode code, std::size_t end) const {
      constexpr Outcode x_sides = bit(Plane::left) | bit(Plane::right);
      Region r;
      if ((code & x_sides) != 0) r.missed = !cross(r.x, code & x_sides, end);
      if ((code & ~x_sides) != 0) r.missed = !cross(r.y, code & ~x_sides, end) || r.missed;
      return r;
    }

    // Whether the other end is inside of the side that this one is beyond, and not on it.
    constexpr bool cross(Binding& binding, Outcode code, std::size_t end) const {
      const auto side = static_cast<Plane>(std::countr_zero(code));
      const typename S::ScalarType d_kept = space.distance(side, segment[1 - end]);
      const typename S::ScalarType d_cut = space.distance(side, segment[end]);
      binding = {true, side, d_kept, d_cut};
      return segment_side(d_kept, d_cut) == SegmentSide::cut_second;
    }

    static constexpr Binding tighter(const Binding& a, const Binding& b) {
      Binding r = a;
      if (b.binds) r.tighten(b.plane, b.d_kept, b.d_cut);
      return r;
    }
  };
};

namespace window {

template <Scalar T>
constexpr std::optional<Segment2<T>> nicholl_lee_nicholl(const Rectangle<T>& rectangle,
                                                         const Segment2<T>& segment) {
  return clip(NichollLeeNicholl{}, rectangle, segment);
}

}  // namespace window

struct WindowNichollLeeNicholl : StartsInClipSpace<DepthCutThenWindow<NichollLeeNicholl>> {
  static constexpr std::string_view name = "window/nicholl_lee_nicholl";
  static constexpr std::string_view summary =
      "near and far cut in clip space, divide, then Nicholl-Lee-Nicholl in 2D";
  static constexpr std::string_view source =
      "Nicholl, Lee and Nicholl, An Efficient New Algorithm for 2-D Line Clipping, 1987";
  static constexpr Promise promise = window_promise(kParametricUlps, false);
};

}  // namespace clipscope

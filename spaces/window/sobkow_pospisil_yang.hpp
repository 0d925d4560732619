// SPDX-License-Identifier: MIT
//
// Sobkow, Pospisil and Yang's segment clipper by line encoding: in the plane, and as a clipper in
// the window.
//
// The outcodes of both ends together are the code of the line, one of 81. A case for each code
// knows the sides that a line of that code can cross, and in which order to try them, so that no
// outcode is computed again:
//
//   one end inside    the other moves to left or right first, then to bottom or top if still beyond
//   two sides         the first end moves; beyond the other end's side, the line misses; the other
//                     end moves
//   side and corner   the same, and the end beyond the corner may then move to its second side
//   two corners       both move to left and right; either may miss, or move to bottom or top
//
// Each move starts from the segment as it is by then. The cases are made from their two codes at
// compile time, those that are mirror images or reverses of each other by the same rule.
// Source: Sobkow, Pospisil and Yang, "A Fast Two-Dimensional Line Clipping Algorithm via Line
// Encoding", Computers & Graphics 11(4), 1987; by a public implementation in C that writes the 81
// cases out. There some reverses move the two ends in the other order.
// Guarantees: no division but for an intersection with a side that the line's code names; none to
// accept, or to reject by the code; no division by zero: an end moves to a side that it is beyond
// and the other end is not.
// Does not guarantee: the same bits for a segment and its reverse where both ends move. (The
// clipper:) an answer where w <= 0 is left after the cut by near and far.
#pragma once

#include <bit>
#include <utility>

#include "spaces/window/rectangle.hpp"
#include "spaces/window/segment_steps.hpp"

namespace clipscope {

struct SobkowPospisilYang {
  // The part of the segment that is inside, or none.
  template <PlanarSpace S>
  constexpr std::optional<SegmentIn<S>> operator()(const S& space,
                                                   const SegmentIn<S>& segment) const {
    const Outcode first = space.outcode(segment[0]);
    const Outcode second = space.outcode(segment[1]);
    return kCases<S>[first << 4 | second](space, segment);
  }

 private:
  template <class S>
  using Case = std::optional<SegmentIn<S>> (*)(const S&, const SegmentIn<S>&);

  static constexpr Outcode kXSides = bit(Plane::left) | bit(Plane::right);
  static constexpr Outcode kYSides = bit(Plane::bottom) | bit(Plane::top);

  static constexpr bool is_corner(Outcode code) { return (code & kXSides) && (code & kYSides); }
  static constexpr Plane side_of(Outcode one_bit) {
    return static_cast<Plane>(std::countr_zero(one_bit));
  }

  template <class S>
  struct Walk {
    using T = typename S::ScalarType;

    const S& space;
    SegmentIn<S> ends;

    template <Plane kSide>
    constexpr bool is_beyond(std::size_t end) const {
      const T& at = space.position(ends[end])[side_axis(kSide)];
      const T& side = side_coordinate(space.rectangle(), kSide);
      return kSide == Plane::left || kSide == Plane::bottom ? at < side : side < at;
    }

    // y = y0 + (y1 - y0) (side - x0) / (x1 - x0), (x0, y0) being the end that moves.
    template <Plane kSide>
    constexpr void move(std::size_t end) {
      constexpr int kAxis = side_axis(kSide);
      const auto& from = space.position(ends[end]);
      const auto& to = space.position(ends[1 - end]);
      const T& side = side_coordinate(space.rectangle(), kSide);
      const T rise = (to[1 - kAxis] - from[1 - kAxis]) * (side - from[kAxis]);
      const T run = to[kAxis] - from[kAxis];
      Vec2<T> at;
      at[kAxis] = side;
      at[1 - kAxis] = from[1 - kAxis] + rise / run;
      ends[end] = space.meet_at(kSide, ends[1 - end], ends[end], at);
    }

    template <Plane kSide>
    constexpr void move_if_beyond(std::size_t end) {
      if (is_beyond<kSide>(end)) move<kSide>(end);
    }
  };

  // The other end is inside.
  template <Outcode kCode, class S>
  static constexpr bool clip_one(Walk<S>& walk, std::size_t end) {
    if constexpr (is_corner(kCode)) {
      walk.template move<side_of(kCode & kXSides)>(end);
      walk.template move_if_beyond<side_of(kCode & kYSides)>(end);
    } else {
      walk.template move<side_of(kCode)>(end);
    }
    return true;
  }

  template <Outcode kFirst, Outcode kSecond, class S>
  static constexpr bool clip_sides(Walk<S>& walk) {
    walk.template move<side_of(kFirst)>(0);
    if constexpr (side_axis(side_of(kFirst)) != side_axis(side_of(kSecond))) {
      if (walk.template is_beyond<side_of(kSecond)>(0)) return false;
    }
    walk.template move<side_of(kSecond)>(1);
    return true;
  }

  // `end` is beyond one side, the other one beyond a corner.
  template <Outcode kSide, Outcode kCorner, class S>
  static constexpr bool clip_side_and_corner(Walk<S>& walk, std::size_t end) {
    constexpr Outcode kOwnAxis = (kSide & kXSides) != 0 ? kXSides : kYSides;
    constexpr Plane kAcross = side_of(kCorner & kOwnAxis);
    constexpr Plane kBeside = side_of(kCorner & ~kOwnAxis);
    walk.template move<side_of(kSide)>(end);
    if (walk.template is_beyond<kBeside>(end)) return false;
    walk.template move<kBeside>(1 - end);
    walk.template move_if_beyond<kAcross>(1 - end);
    return true;
  }

  template <Outcode kFirst, Outcode kSecond, class S>
  static constexpr bool clip_corners(Walk<S>& walk) {
    walk.template move<side_of(kFirst & kXSides)>(0);
    if (walk.template is_beyond<side_of(kSecond & kYSides)>(0)) return false;
    walk.template move<side_of(kSecond & kXSides)>(1);
    if (walk.template is_beyond<side_of(kFirst & kYSides)>(1)) return false;
    walk.template move_if_beyond<side_of(kFirst & kYSides)>(0);
    walk.template move_if_beyond<side_of(kSecond & kYSides)>(1);
    return true;
  }

  template <Outcode kFirst, Outcode kSecond, class S>
  static constexpr bool clip_walk(Walk<S>& walk) {
    if constexpr (kFirst == 0) {
      return clip_one<kSecond>(walk, 1);
    } else if constexpr (kSecond == 0) {
      return clip_one<kFirst>(walk, 0);
    } else if constexpr (is_corner(kFirst) && is_corner(kSecond)) {
      return clip_corners<kFirst, kSecond>(walk);
    } else if constexpr (is_corner(kSecond)) {
      return clip_side_and_corner<kFirst, kSecond>(walk, 0);
    } else if constexpr (is_corner(kFirst)) {
      return clip_side_and_corner<kSecond, kFirst>(walk, 1);
    } else {
      return clip_sides<kFirst, kSecond>(walk);
    }
  }

  template <class S>
  static constexpr std::optional<SegmentIn<S>> accept(const S&, const SegmentIn<S>& segment) {
    return segment;
  }
  template <class S>
  static constexpr std::optional<SegmentIn<S>> reject(const S&, const SegmentIn<S>&) {
    return std::nullopt;
  }
  template <Outcode kFirst, Outcode kSecond, class S>
  static constexpr std::optional<SegmentIn<S>> clip_case(const S& space,
                                                         const SegmentIn<S>& segment) {
    Walk<S> walk{space, segment};
    if (!clip_walk<kFirst, kSecond>(walk)) return std::nullopt;
    return walk.ends;
  }

  // A NaN alone is beyond both sides of an axis.
  static constexpr bool is_nowhere(Outcode code) {
    return (code & kXSides) == kXSides || (code & kYSides) == kYSides;
  }

  template <class S, std::size_t kLine>
  static constexpr Case<S> case_of() {
    constexpr auto kFirst = static_cast<Outcode>(kLine >> 4);
    constexpr auto kSecond = static_cast<Outcode>(kLine & 15);
    if constexpr (kLine == 0) {
      return &accept<S>;
    } else if constexpr ((kFirst & kSecond) != 0 || is_nowhere(kFirst) || is_nowhere(kSecond)) {
      return &reject<S>;
    } else {
      return &clip_case<kFirst, kSecond, S>;
    }
  }

  template <class S, std::size_t... kLines>
  static constexpr std::array<Case<S>, sizeof...(kLines)> cases_of(std::index_sequence<kLines...>) {
    return {case_of<S, kLines>()...};
  }

  // By the code of the first end times 16, plus that of the second.
  template <class S>
  static constexpr std::array<Case<S>, 256> kCases = cases_of<S>(std::make_index_sequence<256>{});
};

namespace window {

template <Scalar T>
constexpr std::optional<Segment2<T>> sobkow_pospisil_yang(const Rectangle<T>& rectangle,
                                                          const Segment2<T>& segment) {
  return clip(SobkowPospisilYang{}, rectangle, segment);
}

}  // namespace window

struct WindowSobkowPospisilYang : StartsInClipSpace<DepthCutThenWindow<SobkowPospisilYang>> {
  static constexpr std::string_view name = "window/sobkow_pospisil_yang";
  static constexpr std::string_view summary =
      "near and far cut in clip space, divide, then a case for each of 81 pairs of outcodes in 2D";
  static constexpr std::string_view source =
      "Sobkow, Pospisil and Yang, A Fast Two-Dimensional Line Clipping Algorithm, 1987";
  static constexpr Promise promise = window_promise(4 * kSegmentCutUlps, false);
};

}  // namespace clipscope

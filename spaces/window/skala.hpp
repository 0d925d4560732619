// SPDX-License-Identifier: MIT
//
// Skala's segment clipper in homogeneous coordinates: in the plane, and as a clipper in the window.
//
// The line through the ends is their cross product p = (a, b, c). On which side of it each of the
// four corners of the window lies, the sign of a x + b y + c, is a code of four bits; a table tells
// from the code which two sides the line crosses. An intersection is the cross product of p and the
// line of a side. Outcodes accept and reject before, and where one end is inside, the other end's
// outcode tells which of the two sides it leaves by.
// Source: Skala, "A New Approach to Line and Line Segment Clipping in Homogeneous Coordinates", The
// Visual Computer 21(11), 2005, algorithm 2 and its form for segments; by two public
// implementations that agree. The table is made here: a side is crossed if its corners differ.
// Repaired: a line that lies in a side has no corner beyond it in one of its two directions, and
// would be lost; where every corner is on one side or on the line, those on the line count as
// beyond. Where both ends are moved the paper gives the part in any direction; here the end that is
// outside of a side is the one that moves to it. Intersections are divided at once, without the
// products by 0 and 1 of a side's line.
// Guarantees: no division unless an end is moved, and one for each such end.
// Does not guarantee: any bound on the error in rounded arithmetic: c has rounding of the size of a
// product of coordinates, so that the line through two near points is wrong in most of its digits.
// A corner on the wrong side of it then takes the intersection with a side that the segment does
// not cross. (The clipper:) an answer where w <= 0 is left after the cut by near and far.
#pragma once

#include "spaces/window/planar_ends.hpp"
#include "spaces/window/segment_steps.hpp"

namespace clipscope {

struct SkalaHomogeneous {
  // The part of the segment that is inside, or none.
  template <PlanarSpace S>
  constexpr std::optional<SegmentIn<S>> operator()(const S& space,
                                                   const SegmentIn<S>& segment) const {
    using T = typename S::ScalarType;
    const std::array<Outcode, 2> code = {space.outcode(segment[0]), space.outcode(segment[1])};
    if ((code[0] | code[1]) == 0) return segment;
    if ((code[0] & code[1]) != 0) return std::nullopt;
    std::array<PlanarEnd<T>, 2> ends = planar_ends(space, segment);
    const Line<T> line = line_through(ends[0].at, ends[1].at);
    const Crossing crossed = kCrossings[corner_code(line, space.rectangle())];
    if (!crossed.is_crossed) return std::nullopt;
    for (std::size_t i = 0; i < 2; ++i) {
      if (code[i] == 0) continue;
      const bool by_second = (code[i] & bit(crossed.sides[1])) != 0;
      meet(line, space.rectangle(), crossed.sides[by_second ? 1 : 0], ends[i]);
    }
    return place_ends(space, segment, ends);
  }

 private:
  // a x + b y + c = 0.
  template <class T>
  struct Line {
    T a, b, c;
  };

  // The sides that a line crosses, by the bits of the corners; none where all bits are equal, or
  // are not what a line makes.
  struct Crossing {
    bool is_crossed = false;
    std::array<Plane, 2> sides{};
  };

  static constexpr std::array<Crossing, 16> make_crossings() {
    // A side and the next one meet in the corner of the next one's number.
    constexpr std::array<Plane, 4> kAround = {Plane::bottom, Plane::right, Plane::top, Plane::left};
    std::array<Crossing, 16> table;
    for (unsigned code = 0; code < 16; ++code) {
      std::size_t found = 0;
      for (unsigned side = 0; side < 4; ++side) {
        const unsigned next = (side + 1) % 4;
        if ((code >> side & 1) == (code >> next & 1)) continue;
        if (found < 2) table[code].sides[found] = kAround[side];
        ++found;
      }
      table[code].is_crossed = found == 2;
    }
    return table;
  }
  static const std::array<Crossing, 16> kCrossings;

  template <class T>
  static constexpr Line<T> line_through(const Vec2<T>& p, const Vec2<T>& q) {
    const T a = p[1] - q[1];
    const T b = q[0] - p[0];
    const T c = p[0] * q[1] - p[1] * q[0];
    return {a, b, c};
  }

  // Bits of the corners left bottom, right bottom, right top and left top: on the positive side.
  template <class T>
  static constexpr unsigned corner_code(const Line<T>& line, const Rectangle<T>& r) {
    const auto value = [&](const T& x, const T& y) -> T {
      return line.a * x + line.b * y + line.c;
    };
    const std::array<T, 4> corners = {value(r.left, r.bottom), value(r.right, r.bottom),
                                      value(r.right, r.top), value(r.left, r.top)};
    const T zero(0);
    unsigned code = 0;
    for (unsigned k = 0; k < 4; ++k) code |= static_cast<unsigned>(zero <= corners[k]) << k;
    if (code != 15) return code;
    code = 0;
    for (unsigned k = 0; k < 4; ++k) code |= static_cast<unsigned>(zero < corners[k]) << k;
    return code;
  }

  template <class T>
  static constexpr void meet(const Line<T>& line, const Rectangle<T>& r, Plane side,
                             PlanarEnd<T>& end) {
    const bool is_upright = side_axis(side) == 0;
    const T& coordinate = side_coordinate(r, side);
    const T& factor = is_upright ? line.a : line.b;
    const T& divisor = is_upright ? line.b : line.a;
    const T sum = factor * coordinate + line.c;
    end.move(side, coordinate, T(-sum / divisor));
  }
};

inline constexpr std::array<SkalaHomogeneous::Crossing, 16> SkalaHomogeneous::kCrossings =
    SkalaHomogeneous::make_crossings();

namespace window {

template <Scalar T>
constexpr std::optional<Segment2<T>> skala(const Rectangle<T>& rectangle,
                                           const Segment2<T>& segment) {
  return clip(SkalaHomogeneous{}, rectangle, segment);
}

}  // namespace window

struct WindowSkala : StartsInClipSpace<DepthCutThenWindow<SkalaHomogeneous>> {
  static constexpr std::string_view name = "window/skala";
  static constexpr std::string_view summary =
      "near and far cut in clip space, divide, then Skala's line and corners in 2D";
  static constexpr std::string_view source =
      "Skala, A New Approach to Line and Line Segment Clipping in Homogeneous Coordinates, 2005";
  static constexpr Promise promise = window_promise(kUnbounded, false);
};

}  // namespace clipscope

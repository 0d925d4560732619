// SPDX-License-Identifier: MIT
//
// Cohen and Sutherland's segment clipper, for every space.
//
// Outcodes accept and reject. Else an outside end moves to one of the planes that it is outside of,
// its outcode is computed again, and so on until the outcodes settle it. Each move starts from the
// segment as it is by then: what one plane shortened, the next may shorten again, and all but the
// last of these intersections are thrown away.
// Source: Cohen and Sutherland, in Newman and Sproull, "Principles of Interactive Computer
// Graphics", 1973, chapter 5 (4 bits in a window, 6 bits in a volume).
// Guarantees: it ends: a plane that an end was moved to counts as settled for that end, however the
// move was rounded; so each plane is used twice at most, and once in exact arithmetic.
// Does not guarantee: the same bits for a segment and its reverse where both ends are outside: the
// first end moves first.
#pragma once

#include <bit>

#include "spaces/segment.hpp"

namespace clipscope {

struct CohenSutherland {
  // The part of the segment that is inside, or none.
  template <SegmentSpace S>
  constexpr std::optional<SegmentIn<S>> operator()(const S& space,
                                                   const SegmentIn<S>& segment) const {
    using T = typename S::ScalarType;
    SegmentIn<S> ends = segment;
    std::array<Outcode, 2> code = {space.outcode(ends[0]), space.outcode(ends[1])};
    std::array<Outcode, 2> settled = {0, 0};
    while ((code[0] | code[1]) != 0) {
      if ((code[0] & code[1]) != 0) return std::nullopt;
      const std::size_t moved = code[0] != 0 ? 0 : 1;
      const std::size_t kept = 1 - moved;
      const auto plane = static_cast<Plane>(std::countr_zero(code[moved]));
      const PlaneCut<T> cut =
          cut_segment(space.distance(plane, ends[kept]), space.distance(plane, ends[moved]));
      if (cut.side != SegmentSide::cut_second || !(T(0) < cut.t)) return std::nullopt;
      ends[moved] = space.meet(plane, ends[kept], ends[moved], cut.t);
      settled[moved] |= bit(plane);
      code[moved] = space.outcode(ends[moved]) & ~settled[moved];
    }
    return ends;
  }
};

}  // namespace clipscope

// SPDX-License-Identifier: MIT
//
// How far the ends of a segment may stay from each other: the parameters at which planes let it in
// and out.
//
// A plane whose distance grows from the first end to the second lets the segment in and bounds the
// first end; one whose distance shrinks bounds the second. Each end keeps the plane that leaves
// least of the segment. Parameters are measured from the other end, the one that is kept, so a
// segment and its reverse give the same bits, and a segment cut by one plane those of a polygon's
// edge.
// Source: Cyrus and Beck, "Generalized Two- and Three-Dimensional Clipping", Computers & Graphics
// 3(1), 1978; Liang and Barsky, "A New Concept and Method for Line Clipping", ACM TOG 3(1), 1984.
// Does not guarantee: the exact order of planes whose parameters differ by less than rounding.
#pragma once

#include "spaces/segment.hpp"

namespace clipscope {

// PlaneId: how a plane is called; Plane, or the number of an edge.
template <Scalar T, class PlaneId = Plane>
class ParametricBounds {
 public:
  // Takes a plane into account, by the signed distances of the two ends. Returns whether more than
  // a point can be left; a NaN leaves nothing.
  constexpr bool cut(PlaneId plane, const T& d_first, const T& d_second) {
    if (d_first < d_second) return tighten(bounds_[0], plane, d_second, d_first) && overlap();
    if (d_second < d_first) return tighten(bounds_[1], plane, d_first, d_second) && overlap();
    return T(0) <= d_first && T(0) <= d_second;
  }

  // What is left. Pre-condition: every cut returned true.
  template <class S, class Point>
  constexpr std::array<Point, 2> move_ends(const S& space,
                                           const std::array<Point, 2>& segment) const {
    std::array<Point, 2> ends = segment;
    for (std::size_t i = 0; i < 2; ++i) {
      const Bound& b = bounds_[i];
      if (b.moves()) ends[i] = space.meet(b.plane, segment[1 - i], segment[i], b.t);
    }
    return ends;
  }

 private:
  // The plane that moves an end, and how much of the segment it leaves, from the other end: t >= 1
  // moves nothing.
  struct Bound {
    PlaneId plane{};
    T t = T(1);

    constexpr bool moves() const { return t < T(1); }
  };

  // d_kept > d_cut, of any sign. Returns whether more than a point can be inside.
  static constexpr bool tighten(Bound& bound, PlaneId plane, const T& d_kept, const T& d_cut) {
    const T t = cut_parameter(d_kept, d_cut);
    if (!(T(0) < t)) return false;
    if (t < bound.t) bound = {plane, t};
    return true;
  }

  // Whether the ends, as moved, still come in their order. Where one end stays nothing can go
  // wrong; and 1 + t would lose a small t.
  constexpr bool overlap() const {
    return !bounds_[0].moves() || !bounds_[1].moves() || T(1) < bounds_[0].t + bounds_[1].t;
  }

  std::array<Bound, 2> bounds_;  // of the first end and of the second
};

}  // namespace clipscope

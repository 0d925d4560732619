// SPDX-License-Identifier: MIT
//
// Liang and Barsky's segment clipper, for every space, in two variants.
//
// Each plane either lets the segment in (d grows from the first end to the second) or lets it out.
// The plane that lets it in last and the plane that lets it out first bound what is visible, if the
// first of these comes before the second. Both ends are found from the original ends, each once.
//
//   always           as published: a quotient for every plane that the segment is not parallel to
//   when_shortened   planes are compared by products: a plane lets in later than another if its
//                    |d_first| / d_second is larger, and what is visible has d_first e_second <
//                    e_first d_second (d lets in, e lets out). One division for each end that is
//                    really moved, none to accept or reject.
//
// Source: Liang and Barsky, "A New Concept and Method for Line Clipping", ACM TOG 3(1), 1984; the
// same in homogeneous coordinates: section 5 there, and Blinn, "A Trip Down the Graphics Pipeline:
// Line Clipping", IEEE CG&A 11(1), 1991. Comparing products: this project.
// Parameters are measured from the end that is kept, not from the first end, so a segment and its
// reverse give the same bits, and a segment cut by one plane those of a polygon's edge.
// Does not guarantee: that when_shortened never divides more: where products leave the scalar's
// range it compares quotients.
#pragma once

#include "spaces/binding_plane.hpp"

namespace clipscope {

enum class DivisionPolicy { always, when_shortened };

template <DivisionPolicy kDivision>
struct LiangBarsky {
  // The part of the segment that is inside, or none.
  template <SegmentSpace S>
  constexpr std::optional<SegmentIn<S>> operator()(const S& space,
                                                   const SegmentIn<S>& segment) const {
    using T = typename S::ScalarType;
    if constexpr (kDivision == DivisionPolicy::always) {
      return by_quotients<S, T>(space, segment);
    } else {
      return by_products<S, T>(space, segment);
    }
  }

 private:
  // The plane that moves an end, and how much of the segment it leaves, from the other end: t >= 1
  // moves nothing.
  template <class T>
  struct Bound {
    Plane plane = Plane::left;
    T t = T(1);

    constexpr bool moves() const { return t < T(1); }
  };

  template <class S, class T>
  static constexpr std::optional<SegmentIn<S>> by_quotients(const S& space,
                                                            const SegmentIn<S>& segment) {
    std::array<Bound<T>, 2> bounds;  // of the first end and of the second
    bool visible = true;
    for_each_plane(space.planes(), kAllPlanes, [&](Plane plane) {
      if (!visible) return;
      const T d_first = space.distance(plane, segment[0]);
      const T d_second = space.distance(plane, segment[1]);
      if (d_first < d_second) {
        visible = tighten(bounds[0], plane, d_second, d_first) && overlap(bounds);
      } else if (d_second < d_first) {
        visible = tighten(bounds[1], plane, d_first, d_second) && overlap(bounds);
      } else {
        visible = T(0) <= d_first && T(0) <= d_second;
      }
    });
    if (!visible) return std::nullopt;
    SegmentIn<S> ends = segment;
    if (bounds[0].moves()) {
      ends[0] = space.meet(bounds[0].plane, segment[1], segment[0], bounds[0].t);
    }
    if (bounds[1].moves()) {
      ends[1] = space.meet(bounds[1].plane, segment[0], segment[1], bounds[1].t);
    }
    return ends;
  }

  // d_kept > d_cut, of any sign. Returns whether more than a point can be inside.
  template <class T>
  static constexpr bool tighten(Bound<T>& bound, Plane plane, const T& d_kept, const T& d_cut) {
    const T t = cut_parameter(d_kept, d_cut);
    if (!(T(0) < t)) return false;
    if (t < bound.t) bound = {plane, t};
    return true;
  }

  // Whether the ends, as moved, still come in their order. Where one end stays nothing can go
  // wrong; and 1 + t would lose a small t.
  template <class T>
  static constexpr bool overlap(const std::array<Bound<T>, 2>& bounds) {
    return !bounds[0].moves() || !bounds[1].moves() || T(1) < bounds[0].t + bounds[1].t;
  }

  template <class S, class T>
  static constexpr std::optional<SegmentIn<S>> by_products(const S& space,
                                                           const SegmentIn<S>& segment) {
    std::array<BindingPlane<T>, 2> bounds;  // of the first end and of the second
    bool visible = true;
    for_each_plane(space.planes(), kAllPlanes, [&](Plane plane) {
      if (!visible) return;
      const T d_first = space.distance(plane, segment[0]);
      const T d_second = space.distance(plane, segment[1]);
      const SegmentSide side = segment_side(d_first, d_second);
      if (side == SegmentSide::accepted) return;
      if (side == SegmentSide::cut_first) bounds[0].tighten(plane, d_second, d_first);
      if (side == SegmentSide::cut_second) bounds[1].tighten(plane, d_first, d_second);
      visible = side != SegmentSide::rejected && is_visible(bounds[0], bounds[1]);
    });
    if (!visible) return std::nullopt;
    return move_ends(space, segment, bounds[0], bounds[1]);
  }
};

using LiangBarskyClassical = LiangBarsky<DivisionPolicy::always>;
using LiangBarskyDivisionFree = LiangBarsky<DivisionPolicy::when_shortened>;

}  // namespace clipscope

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
// Does not guarantee: that when_shortened never divides more: where products leave the scalar's
// range it compares quotients.
#pragma once

#include "spaces/binding_plane.hpp"
#include "spaces/parametric_bounds.hpp"

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
  template <class S, class T>
  static constexpr std::optional<SegmentIn<S>> by_quotients(const S& space,
                                                            const SegmentIn<S>& segment) {
    ParametricBounds<T> bounds;
    bool visible = true;
    for_each_plane(space.planes(), kAllPlanes, [&](Plane plane) {
      if (!visible) return;
      visible =
          bounds.cut(plane, space.distance(plane, segment[0]), space.distance(plane, segment[1]));
    });
    if (!visible) return std::nullopt;
    return bounds.move_ends(space, segment);
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

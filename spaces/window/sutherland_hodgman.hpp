// SPDX-License-Identifier: MIT
//
// Sutherland-Hodgman for polygons in the window: x and y against the sides of a rectangle, in
// place.
//
// Source: Sutherland and Hodgman, "Reentrant Polygon Clipping", CACM 17(1), 1974. Attributes:
// Blinn, "Hyperbolic Interpolation", IEEE CG&A 12(4), 1992.
// Guarantees: only sides that some vertex is outside of cut; on a polygon inside nothing is
// computed. Does not guarantee: that a new vertex (of a polygon in NDC) lies on its side to the
// last bit.
#pragma once

#include "spaces/cut.hpp"
#include "spaces/window/rectangle.hpp"

namespace clipscope::window {

// Cuts a divided polygon by the four sides, with perspective-correct depth, 1/w and attributes.
// Fewer than three vertices are nothing. Pre-condition: w > 0 at every vertex.
template <Scalar T, int K>
constexpr void cut_sides(const Rectangle<T>& rectangle, NdcPolygon<T, K>& polygon) {
  Outcode all = kSidePlanes;
  Outcode any = 0;
  for (const NdcVertex<T, K>& v : polygon) {
    const Outcode code = side_outcode(rectangle, v.position);
    all &= code;
    any |= code;
  }
  if (all != 0) {
    polygon.clear();
  } else if (any != 0) {
    NdcPolygon<T, K> scratch;
    const NdcPolygon<T, K>& rest = cut_by_planes(
        polygon, scratch, any, kAllPlanes,
        [&](Plane side, const NdcVertex<T, K>& v) {
          return side_distance(rectangle, side, v.position);
        },
        [](const NdcVertex<T, K>& inside, const NdcVertex<T, K>& outside, const T& t) {
          return cvv::interpolate_perspective(inside, outside, t);
        });
    if (&rest != &polygon) polygon = rest;
    polygon.drop_if_degenerate();
    clear_if_overflowed(polygon);
  }
}

// The same for a polygon of the plane: any list of Vec2 that `cut` takes. A new point gets the
// coordinate of its side exactly. `scratch` is overwritten; lists that own memory keep it.
template <Scalar T, class Points>
constexpr void cut_sides(const Rectangle<T>& rectangle, Points& polygon, Points& scratch) {
  const RectangleSpace<T> space(rectangle);
  for (const Plane side : kSides) {
    cut(
        polygon, scratch, [&](const Vec2<T>& p) { return space.distance(side, p); },
        [&](const Vec2<T>& inside, const Vec2<T>& outside, const T& t) {
          return space.meet(side, inside, outside, t);
        });
    std::swap(polygon, scratch);
  }
  if (polygon.size() < 3) polygon.clear();
}

}  // namespace clipscope::window

// SPDX-License-Identifier: MIT
//
// A bounding volume against a view volume along every axis that may separate the two: exact in
// kind, where the planes alone (visibility.hpp) leave boxes beside an edge or a corner of the view
// volume unsettled.
//
// Two convex polyhedra are disjoint exactly if a plane parallel to a face of one of them, or to an
// edge of each, separates them: Gottschalk, Lin and Manocha, "OBBTree: A Hierarchical Structure for
// Rapid Interference Detection", SIGGRAPH 1996; Ericson, "Real-Time Collision Detection", 2005,
// section 5.2. Of an axis-aligned box and a frustum that makes 3 + 5 + 3 x 6 = 26 axes. A sphere is
// disjoint from a polyhedron exactly if the direction to its centre from the nearest face, edge or
// corner separates them.
//
// Rounding. Whatever rounding did to an axis n: if n separates, the two are disjoint. With m, the
// least value of n . q over the volume, less its error (distance_error), the whole view volume lies
// below m if n . position - m weight <= 0 at each of its corners (culling_hull.hpp), which must
// hold by more than the error of that sum. The axes of an axis-aligned box are the same for every
// box, so the bounds of the view volume along them are kept in the hull (slabs).
//
// Guarantees: those of visibility() for planes with a reach; a volume rejected by an axis has no
// point in common with the exact view volume, in every rounding mode (the hull being made in
// round-to-nearest). A hull that is not known, NaN, infinity and overflow settle nothing.
// Does not guarantee: that disjoint volumes closer to each other than rounding are rejected.
#pragma once

#include "spaces/bounds/culling_hull.hpp"
#include "spaces/bounds/visibility.hpp"

namespace clipscope {

namespace bounds {

// Whether the slab and the box have no point in common.
template <std::floating_point T>
bool are_disjoint(const HullSlab<T>& slab, const AxisBox<T>& box) {
  T least(0), magnitude(0);
  for (int i = 0; i < 3; ++i) {
    const T a = slab.normal[i] * box.lower[i], b = slab.normal[i] * box.upper[i];
    least += std::min(a, b);
    magnitude += std::max(std::abs(a), std::abs(b));
  }
  return least - distance_error(magnitude) > slab.most;
}

// Whether n, which points from the view volume to the other one, separates the two: `least` is the
// least n . q of the other, give or take an error of at most that of terms as large as `magnitude`.
template <std::floating_point T>
bool separates(const CullingHull<T>& hull, const Vec3<T>& n, const T& least, const T& magnitude,
               const T& factor) {
  return is_bounded_by(hull, n, T(least - distance_error(magnitude, factor)));
}

template <std::floating_point T>
bool separates(const CullingHull<T>& hull, const Vec3<T>& n, const OrientedBox<T>& box) {
  T extent(0);
  Vec3<T> most = absolute(box.centre);
  for (int i = 0; i < 3; ++i) {
    const Vec3<T>& axis = box.axes[static_cast<std::size_t>(i)];
    extent += box.half[i] * std::abs(dot(n, axis));
    most += box.half[i] * absolute(axis);
  }
  const T factor = box.half[0] + box.half[1] + box.half[2];
  return separates(hull, n, dot(n, box.centre) - extent, dot(absolute(n), most), factor);
}

template <std::floating_point T>
bool separates(const CullingHull<T>& hull, const Vec3<T>& n, const Sphere<T>& sphere) {
  const T extent = length_above(n) * sphere.radius;
  const T magnitude = dot(absolute(n), absolute(sphere.centre)) + extent;
  return separates(hull, n, dot(n, sphere.centre) - extent, magnitude, sphere.radius);
}

// The same for n and for -n.
template <std::floating_point T, class Volume>
bool separate_along(const CullingHull<T>& hull, const Vec3<T>& n, const Volume& volume) {
  return separates(hull, turned_back(hull, n), volume) ||
         separates(hull, turned_back(hull, Vec3<T>(-n)), volume);
}

// What the planes of the view volume do not tell.
template <std::floating_point T>
bool are_separated(const CullingHull<T>& hull, const AxisBox<T>& box) {
  if (are_disjoint(hull.reach, box)) return true;
  for (int i = 0; i < hull.slab_count; ++i) {
    if (are_disjoint(hull.slabs[static_cast<std::size_t>(i)], box)) return true;
  }
  return false;
}

// The faces of the box, and its edges with those of the view volume.
template <std::floating_point T>
bool are_separated(const CullingHull<T>& hull, const OrientedBox<T>& box) {
  const auto& [u, v, w] = box.axes;
  for (const Vec3<T>& face : {cross(u, v), cross(v, w), cross(w, u)}) {
    if (separate_along(hull, face, box)) return true;
  }
  for (int e = 0; e < hull.edge_count; ++e) {
    for (const Vec3<T>& axis : box.axes) {
      const Vec3<T>& edge = hull.edges[static_cast<std::size_t>(e)];
      if (separate_along(hull, cross(axis, edge), box)) return true;
    }
  }
  return false;
}

template <std::floating_point T>
bool are_separated(const CullingHull<T>& hull, const Sphere<T>& sphere) {
  for (const HullCorner<T>& c : hull.corners) {
    // The direction from the corner, times its weight: not far off where that is 0.
    if (separates(hull, Vec3<T>(c.weight * sphere.centre - c.position), sphere)) return true;
  }
  for (std::size_t e = 0; e < kHullEdges; ++e) {
    const auto [i, j] = hull_edge(e);
    const HullCorner<T>&a = hull.corners[i], &b = hull.corners[j];
    const HullCorner<T>& c = a.weight < b.weight ? b : a;  // a point, where one is at infinity
    const Vec3<T> along = edge_direction(a, b);
    const Vec3<T> from = c.weight * sphere.centre - c.position;
    const Vec3<T> across = dot(along, along) * from - dot(along, from) * along;
    if (separate_along(hull, across, sphere)) return true;
  }
  return false;
}

}  // namespace bounds

// The answer of the planes, and where they leave it open that of the hull's axes.
// Pre-condition: planes and hull are those of the same frustum or matrix.
template <std::floating_point T, class Volume>
Visibility visibility(const CullingPlanes<T>& planes, const CullingHull<T>& hull,
                      const Volume& volume) {
  const Visibility answer = visibility(planes, volume);
  if (answer != Visibility::look_closer || !hull.known || !is_finite(volume)) return answer;
  return bounds::are_separated(hull, volume) ? Visibility::rejected : Visibility::look_closer;
}

}  // namespace clipscope

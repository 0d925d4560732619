// SPDX-License-Identifier: MIT
//
// A bounding volume against a view volume: is it all outside, all inside, or must one look closer?
//
// Boxes: only the corner that lies furthest along a plane's normal, and the one furthest against
// it, are looked at: Greene, "Detecting Intersection of a Rectangular Solid and a Convex
// Polyhedron", Graphics Gems IV, 1994; Assarsson and Moeller, "Optimized View Frustum Culling
// Algorithms for Bounding Boxes", Journal of Graphics Tools 5(1), 2000 (p-vertex and n-vertex,
// masking of planes). A box that lies beside the whole volume, but outside of no single plane, is
// found by comparing it with the volume's own box, as Quilez does ("Correct frustum culling",
// 2013).
//
// Guarantees, for float and double, rounding included, in every rounding mode (culling_planes.hpp):
//   - planes of a frustum: a rejected volume has no point in common with the exact closed frustum,
//     an accepted one lies wholly inside it (reference::Truth::of_frustum);
//   - planes of a projection or matrix: the same with the exact volume that the matrix as given
//     cuts out (w >= |x| and so on), and also with what a clipper sees that transforms in T: every
//     representable point of a rejected volume gets the same bit in its clip_outcode, and every one
//     of an accepted volume gets the outcode 0 and w > 0, whatever the order of summation. So a
//     renderer that draws accepted meshes without clipping, or skips rejected ones, draws what it
//     would have drawn.
//   - any NaN or infinity in a volume, and any overflow: look_closer;
//   - an empty volume is rejected.
// For a clip-space clipper, accepted against a *frustum* doesn't mean outcode 0: its vertices may
// come out of the rounded matrix a few ulps beyond +-w. Use the planes of its projection there.
//
// Does not guarantee: that a volume which is outside is rejected. Boxes near edges and corners of
// the frustum may be outside without being outside of one plane (separating_axes.hpp settles
// them), and a volume that comes within rounding of a plane (touches it, say) gets look_closer.
// Pre-condition for more than look_closer: finite planes.
#pragma once

#include <cstdint>

#include "spaces/bounds/culling_planes.hpp"

namespace clipscope {

enum class Visibility : std::uint8_t {
  rejected,    // nothing of it is visible
  accepted,    // all of it is inside: nothing to clip
  look_closer  // anything else: test what it contains, or clip
};

// Bit i is set if plane i of CullingPlanes must still be looked at.
using PlaneMask = std::uint32_t;

template <std::floating_point T>
constexpr PlaneMask all_planes(const CullingPlanes<T>& planes) {
  return (PlaneMask{1} << planes.count) - 1;
}

namespace bounds {

enum class Side : std::uint8_t { outside, inside, unsettled };

// The side of a volume whose distances are low to high, give or take `error`. False comparisons
// with NaN leave it unsettled.
template <std::floating_point T>
constexpr Side side_of(const T& low, const T& high, const T& error) {
  if (high < -error) return Side::outside;
  return low > error ? Side::inside : Side::unsettled;
}

template <std::floating_point T>
Side side_of(const CullingPlane<T>& plane, const AxisBox<T>& box) {
  Vec3<T> along, against, most;
  for (int i = 0; i < 3; ++i) {
    const bool up = plane.normal[i] >= T(0);
    along[i] = up ? box.upper[i] : box.lower[i];
    against[i] = up ? box.lower[i] : box.upper[i];
    most[i] = std::max(std::abs(box.lower[i]), std::abs(box.upper[i]));
  }
  const T low = dot(plane.normal, against) + plane.offset;
  const T high = dot(plane.normal, along) + plane.offset;
  return side_of(low, high, distance_error(dot(plane.weight, most) + plane.offset_weight));
}

template <std::floating_point T>
Side side_of(const CullingPlane<T>& plane, const Sphere<T>& sphere) {
  const T d = dot(plane.normal, sphere.centre) + plane.offset;
  const T extent = plane.normal_length * sphere.radius;
  const T magnitude = dot(plane.weight, absolute(sphere.centre)) + plane.offset_weight +
                      plane.weight_length * sphere.radius;
  return side_of(d - extent, d + extent, distance_error(magnitude));
}

template <std::floating_point T>
Side side_of(const CullingPlane<T>& plane, const OrientedBox<T>& box) {
  const T d = dot(plane.normal, box.centre) + plane.offset;
  T extent(0);
  Vec3<T> most = absolute(box.centre);
  for (int i = 0; i < 3; ++i) {
    const Vec3<T>& axis = box.axes[static_cast<std::size_t>(i)];
    extent += box.half[i] * std::abs(dot(plane.normal, axis));
    most += box.half[i] * absolute(axis);
  }
  const T magnitude = dot(plane.weight, most) + plane.offset_weight;
  const T factor = box.half[0] + box.half[1] + box.half[2];
  return side_of(d - extent, d + extent, distance_error(magnitude, factor));
}

// Holds the volume against the planes in `mask` and takes out those that it is inside of.
template <std::floating_point T, class Volume>
Visibility against_planes(const CullingPlanes<T>& planes, const Volume& volume, PlaneMask& mask) {
  for (int i = 0; i < planes.count; ++i) {
    if ((mask >> i & 1) == 0) continue;
    switch (side_of(planes.planes[static_cast<std::size_t>(i)], volume)) {
      case Side::outside: return Visibility::rejected;
      case Side::inside: mask &= ~(PlaneMask{1} << i); break;
      case Side::unsettled: break;
    }
  }
  return mask == 0 && planes.count > 0 ? Visibility::accepted : Visibility::look_closer;
}

// Comparisons only: exact.
template <std::floating_point T>
constexpr bool are_disjoint(const AxisBox<T>& a, const AxisBox<T>& b) {
  for (int i = 0; i < 3; ++i) {
    if (a.upper[i] < b.lower[i] || b.upper[i] < a.lower[i]) return true;
  }
  return false;
}

// Whether the volume lies beside the view volume's own box; known of boxes.
template <std::floating_point T, class Volume>
constexpr bool is_beyond_reach(const CullingPlanes<T>&, const Volume&) {
  return false;
}
template <std::floating_point T>
constexpr bool is_beyond_reach(const CullingPlanes<T>& planes, const AxisBox<T>& box) {
  return are_disjoint(planes.reach, box);
}

}  // namespace bounds

// The same for what is known to be inside of some planes, as a part of something larger is: `mask`
// holds the planes of which that is not known, and receives those of this volume. The answer is
// rejected, or accepted if none is left.
template <std::floating_point T, class Volume>
Visibility visibility(const CullingPlanes<T>& planes, const Volume& volume, PlaneMask& mask) {
  if (!is_finite(volume)) return Visibility::look_closer;
  if (is_empty(volume) || bounds::is_beyond_reach(planes, volume)) return Visibility::rejected;
  return bounds::against_planes(planes, volume, mask);
}

template <std::floating_point T, class Volume>
Visibility visibility(const CullingPlanes<T>& planes, const Volume& volume) {
  PlaneMask mask = all_planes(planes);
  return visibility(planes, volume, mask);
}

}  // namespace clipscope

// SPDX-License-Identifier: MIT
//
// Sutherland-Hodgman in homogeneous clip space, before the divide, driven by outcodes.
//
// Outcodes accept what is inside and reject what is outside one plane without computing anything;
// the rest is cut by just the planes that some vertex is outside of. Two policies: the order of the
// planes, and an extra plane w >= epsilon in front of the others, as many renderers have it so that
// nothing is ever divided by zero.
// Source: Sutherland and Hodgman, "Reentrant Polygon Clipping", CACM 17(1), 1974; outcodes: Cohen
// and Sutherland, in Newman and Sproull, "Principles of Interactive Computer Graphics", 1973;
// homogeneous: Blinn and Newell, "Clipping Using Homogeneous Coordinates", SIGGRAPH 1978; a w-plane
// of 1e-5: practice of software renderers; of 1/16384: Skia (kW0PlaneDistance).
// Guarantees: the vertices on an edge depend on that edge alone, bit for bit (measured.hpp).
// Does not guarantee: coordinates within the volume to the last bit after the divide; the exact
// vertex count where a vertex comes within rounding of a plane. A w-plane with epsilon > 0 loses
// what is nearer to the eye than that and makes the result depend on the scale of homogeneous
// coordinates.
#pragma once

#include <limits>

#include "spaces/homogeneous/by_outcodes.hpp"

namespace clipscope {

// The order in which planes cut. Near first: what is behind the eye goes at once. Near last: sides
// first, as in OpenGL's order of the planes.
enum class PlaneOrder { near_first, near_last };

// The extra plane w >= epsilon, cut first. The epsilons are floats, in every scalar.
enum class WPlane { none, zero, smallest_normal, one_16384th, one_100000th };

template <PlaneOrder kOrder>
inline constexpr std::array<Plane, kPlanes> kPlaneOrder =
    kOrder == PlaneOrder::near_first
        ? kNearFirst
        : std::array{Plane::left, Plane::right, Plane::bottom, Plane::top, Plane::far, Plane::near};

constexpr float w_plane_epsilon(WPlane plane) {
  switch (plane) {
    case WPlane::smallest_normal: return std::numeric_limits<float>::min();
    case WPlane::one_16384th: return 1.0f / 16384;
    case WPlane::one_100000th: return 1e-5f;
    default: return 0;
  }
}

template <PlaneOrder kOrder, WPlane kWPlane = WPlane::none>
struct HomogeneousSutherlandHodgmanWith
    : CutsByOutcodes<HomogeneousSutherlandHodgmanWith<kOrder, kWPlane>> {
  static constexpr bool kHasEpsilon = w_plane_epsilon(kWPlane) > 0;

  static constexpr std::string_view name = [] {
    switch (kWPlane) {
      case WPlane::none: break;
      case WPlane::zero: return "homogeneous/w_first_0";
      case WPlane::smallest_normal: return "homogeneous/w_first_flt_min";
      case WPlane::one_16384th: return "homogeneous/w_first_1_16384";
      case WPlane::one_100000th: return "homogeneous/w_first_1e-5";
    }
    return kOrder == PlaneOrder::near_first ? "homogeneous/sutherland_hodgman"
                                            : "homogeneous/near_last";
  }();
  static constexpr std::string_view summary = [] {
    switch (kWPlane) {
      case WPlane::none: break;
      case WPlane::zero: return "Sutherland-Hodgman in clip space after a cut by w >= 0";
      case WPlane::smallest_normal:
        return "Sutherland-Hodgman in clip space after a cut by w >= FLT_MIN";
      case WPlane::one_16384th:
        return "Sutherland-Hodgman in clip space after a cut by w >= 1/16384";
      case WPlane::one_100000th: return "Sutherland-Hodgman in clip space after a cut by w >= 1e-5";
    }
    return kOrder == PlaneOrder::near_first
               ? "Sutherland-Hodgman in clip space; outcodes accept, reject and choose the planes"
               : "the same, near plane last";
  }();
  static constexpr std::string_view source =
      "Blinn and Newell, Clipping Using Homogeneous Coordinates, 1978";
  static constexpr Promise promise{.covers = !kHasEpsilon,
                                   .ulps = kChainUlps,
                                   .watertight = true,
                                   .scale_invariant = !kHasEpsilon};

  using CutsByOutcodes<HomogeneousSutherlandHodgmanWith>::cut;

  // Whether a vertex is behind the w-plane.
  template <Scalar T>
  static constexpr bool is_cut_anyway(const std::array<Vec4<T>, 3>& positions) {
    if constexpr (kHasEpsilon) {
      for (const Vec4<T>& p : positions) {
        if (w_distance(p) < T(0)) return true;
      }
    }
    return false;
  }

  // The same by the planes of the code alone, of the triangle in `polygon`; with vertices that are
  // not in front of the eye. It comes back in one of the two lists.
  template <class V>
  static constexpr const VertexList<V>& cut(const ClipVolume& volume, Outcode planes,
                                            VertexList<V>& polygon, VertexList<V>& scratch) {
    clear_unless_finite(polygon);
    if constexpr (kWPlane != WPlane::none) {
      cut_if_crossed(polygon, scratch, [](const V& v) { return w_distance(v.position); });
    }
    return cut_by_planes(
        polygon, scratch, planes, kPlaneOrder<kOrder>,
        [&](Plane plane, const V& v) { return signed_distance(volume.depth, plane, v); });
  }

 private:
  template <Scalar T>
  static constexpr T w_distance(const Vec4<T>& position) {
    const T epsilon(w_plane_epsilon(kWPlane));
    return position[3] - epsilon;
  }
};

using HomogeneousSutherlandHodgman = HomogeneousSutherlandHodgmanWith<PlaneOrder::near_first>;
using HomogeneousNearLast = HomogeneousSutherlandHodgmanWith<PlaneOrder::near_last>;
template <WPlane kWPlane>
using HomogeneousWFirst = HomogeneousSutherlandHodgmanWith<PlaneOrder::near_first, kWPlane>;

}  // namespace clipscope

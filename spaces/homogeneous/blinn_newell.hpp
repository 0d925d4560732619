// SPDX-License-Identifier: MIT
//
// Blinn and Newell's clipper: boundary coordinates computed once per vertex and interpolated.
//
// Each vertex carries its signed distances to all planes, its boundary coordinates. Their signs
// accept and reject; a new vertex gets its boundary coordinates by the same interpolation as its
// position, from the inside end, so that nothing is ever computed from a rounded position.
// Source: Blinn and Newell, "Clipping Using Homogeneous Coordinates", SIGGRAPH 1978.
// Guarantees: the vertices on an edge depend on that edge alone, bit for bit (measured.hpp).
// Does not guarantee: the exact vertex count where a vertex comes within rounding of a plane.
#pragma once

#include "spaces/clipper.hpp"
#include "spaces/cut.hpp"
#include "spaces/homogeneous/divide.hpp"
#include "spaces/measured.hpp"
#include "spaces/planes.hpp"

namespace clipscope {

struct BlinnNewell : StartsInClipSpace<BlinnNewell> {
  static constexpr std::string_view name = "homogeneous/blinn_newell";
  static constexpr std::string_view summary =
      "Sutherland-Hodgman in clip space on boundary coordinates that are interpolated with the vertex";
  static constexpr std::string_view source =
      "Blinn and Newell, Clipping Using Homogeneous Coordinates, 1978";
  static constexpr Promise promise{.ulps = kChainUlps, .watertight = true};

  template <Scalar T, int K>
  static constexpr void clip(const ClipVolume& volume, const ClipTriangle<T, K>& triangle,
                             NdcPolygon<T, K>& out) {
    out.clear();
    cut_and_then(volume, triangle, [&](const auto& rest) { divide(rest, out); });
  }

  template <Scalar T, int K>
  static constexpr ClipPolygon<T, K> cut(const ClipVolume& volume,
                                         const ClipTriangle<T, K>& triangle) {
    ClipPolygon<T, K> out;
    if (is_beyond_open_side(volume, triangle)) return out;
    cut_and_then(volume, triangle, [&](const auto& rest) { out = divisible<T, K>(rest); });
    return out;
  }

 private:
  template <Scalar T, int K>
  using Bounded = MeasuredVertex<Space::clip, T, K>;

  // f(rest): what is left of a triangle that isn't rejected.
  template <Scalar T, int K, class F>
  static constexpr void cut_and_then(const ClipVolume& volume, const ClipTriangle<T, K>& triangle,
                                     F&& f) {
    if (!has_finite_positions(triangle)) return;
    MeasuredPolygon<Space::clip, T, K> polygon, scratch;
    for (const ClipVertex<T, K>& v : triangle) polygon.push_back(measured(volume.depth, v));
    const OutcodeSummary code = summarize_outcodes(
        volume, triangle, [&](std::size_t i) { return outcode(polygon[static_cast<int>(i)]); });
    if (code.all != 0) return;
    f(step_by_planes(
        polygon, scratch, code.any, kAllPlanes, [](Plane plane, const auto& in, auto& out) {
          cut_by_distances(
              in, out, [plane](const Bounded<T, K>& v) { return carried_distance(plane, v); },
              meet<T, K>);
        }));
  }

  template <Scalar T, int K>
  static constexpr Outcode outcode(const Bounded<T, K>& v) {
    Outcode code = 0;
    for (const Plane plane : kAllPlanes) {
      if (!(T(0) <= carried_distance(plane, v))) code |= bit(plane);
    }
    return code;
  }

  template <Scalar T, int K>
  static constexpr Bounded<T, K> meet(const Bounded<T, K>& inside, const Bounded<T, K>& outside,
                                      const T& d_inside, const T& d_outside) {
    const T t = cut_parameter(d_inside, d_outside);
    return interpolate(inside, outside, t);
  }
};

}  // namespace clipscope

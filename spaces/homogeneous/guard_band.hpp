// SPDX-License-Identifier: MIT
//
// Near and far planes in clip space and a guard band at the sides; the rest is left to scissoring.
//
// A side is cut in clip space only where a triangle leaves the guard band |x|, |y| <= 16 w, which a
// rasteriser with 16 bits of integer pixels has at 4K. What reaches into the band is scissored
// after the divide: here by Sutherland-Hodgman in the window, so that the contract's polygon comes
// out.
// Source: Giesen, "A trip through the Graphics Pipeline 2011, part 5", 2011; Microsoft, Direct3D 9
// documentation of D3DCAPS9::GuardBandLeft.
// Does not guarantee: an error independent of depth: scissored vertices are interpolated after the
// divide, where errors grow with w_max / w_min. Clip-space triangles that no projection makes are
// cut by the band to w >= 0, but w_max / w_min is then unbounded.
#pragma once

#include <utility>

#include "spaces/clipper.hpp"
#include "spaces/cut.hpp"
#include "spaces/cvv/sutherland_hodgman.hpp"
#include "spaces/planes.hpp"

namespace clipscope {

inline constexpr int kGuardBand = 16;  // half width of the band, in half widths of the volume

struct HomogeneousGuardBand : StartsInClipSpace<HomogeneousGuardBand> {
  static constexpr std::string_view name = "homogeneous/guard_band";
  static constexpr std::string_view summary =
      "near and far cut in clip space, sides only beyond a guard band, the rest scissored";
  static constexpr std::string_view source = "Direct3D 9 documentation, D3DCAPS9::GuardBandLeft";
  static constexpr Promise promise{.domain = Promise::Domain::divisible,
                                   .ulps = kChainUlps,
                                   .amplification = Promise::Amplification::w_ratio};

  template <Scalar T, int K>
  static constexpr void clip(const ClipVolume& volume, const ClipTriangle<T, K>& triangle,
                             NdcPolygon<T, K>& out) {
    out.clear();
    const OutcodeSummary code = summarize_outcodes(volume, triangle, [&](std::size_t i) {
      return clip_outcode(volume.depth, triangle[i].position);
    });
    if (code.all != 0 || !has_finite_positions(triangle)) return;
    ClipPolygon<T, K> polygon, other;
    polygon.assign(triangle);
    for_each_plane(code.any, kDepthPlanes, [&](Plane plane) {
      cut_if_crossed(polygon, other,
                     [&](const auto& v) { return signed_distance(volume.depth, plane, v); });
    });
    for_each_plane(code.any & kSides, kSidePlanes, [&](Plane plane) {
      cut_if_crossed(polygon, other, [&](const auto& v) { return guard_distance(plane, v); });
    });
    drop_eye(polygon, other);
    cvv::divide_and_cut<AttributeInterpolation::perspective>(volume, code.any & kSides, polygon,
                                                             out);
    out.drop_if_degenerate();
    clear_if_overflowed(out);
  }

 private:
  static constexpr Outcode kSides =
      bit(Plane::left) | bit(Plane::right) | bit(Plane::bottom) | bit(Plane::top);
  // The sides are absent: for_each_plane goes through these and the clip distances.
  static constexpr std::array<Plane, 2> kDepthPlanes = {Plane::near, Plane::far};
  static constexpr std::array<Plane, 4> kSidePlanes = {Plane::left, Plane::right, Plane::bottom,
                                                       Plane::top};

  template <Scalar T, int K>
  static constexpr T guard_distance(Plane plane, const ClipVertex<T, K>& v) {
    const T band = T(kGuardBand) * v.position[3];
    switch (plane) {
      case Plane::left: return band + v.position[0];
      case Plane::right: return band - v.position[0];
      case Plane::bottom: return band + v.position[1];
      default: return band - v.position[1];
    }
  }

  // The homogeneous point 0 0 0 0 is in every band, and outside by definition.
  template <Scalar T, int K>
  static constexpr void drop_eye(ClipPolygon<T, K>& polygon, ClipPolygon<T, K>& other) {
    other.clear();
    for (const ClipVertex<T, K>& v : polygon) {
      if (T(0) < v.position[3]) other.push_back(v);
    }
    std::swap(polygon, other);
  }
};

}  // namespace clipscope

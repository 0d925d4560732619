// SPDX-License-Identifier: MIT
//
// Blinn and Newell's clipper: boundary coordinates computed once per vertex and interpolated.
//
// Each vertex carries its signed distances to all planes, its boundary coordinates. Their signs
// accept and reject; a new vertex gets its boundary coordinates by the same interpolation as its
// position, so that nothing is ever computed from a rounded position.
// Source: Blinn and Newell, "Clipping Using Homogeneous Coordinates", SIGGRAPH 1978.
// Guarantees: the vertices on an edge depend on that edge alone, bit for bit: a boundary coordinate
// interpolated between two that are >= 0 is >= 0 (rounding is monotone), so a plane that the ends
// of an edge are inside of never touches what lies between them, whichever planes the neighbour is
// cut by. Does not guarantee: the exact vertex count where a vertex comes within rounding of a
// plane.
#pragma once

#include "spaces/clipper.hpp"
#include "spaces/cut.hpp"
#include "spaces/homogeneous/divide.hpp"
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
  struct BoundedVertex : ClipVertex<T, K> {
    std::array<T, kMaxPlanes> boundary;
    int planes = kPlanes;
  };
  template <Scalar T, int K>
  using BoundedPolygon = VertexList<BoundedVertex<T, K>>;

  // f(rest): what is left of a triangle that isn't rejected.
  template <Scalar T, int K, class F>
  static constexpr void cut_and_then(const ClipVolume& volume, const ClipTriangle<T, K>& triangle,
                                     F&& f) {
    if (!has_finite_positions(triangle)) return;
    std::array<BoundedVertex<T, K>, 3> vertices;
    for (std::size_t i = 0; i < 3; ++i) vertices[i] = bounded(volume, triangle[i]);
    const OutcodeSummary code =
        summarize_outcodes(volume, triangle, [&](std::size_t i) { return outcode(vertices[i]); });
    if (code.all != 0) return;
    BoundedPolygon<T, K> polygon, scratch;
    polygon.assign(vertices);
    f(cut_by_planes(
        polygon, scratch, code.any, kAllPlanes,
        [](Plane plane, const BoundedVertex<T, K>& v) {
          return v.boundary[static_cast<std::size_t>(plane)];
        },
        meet<T, K>));
  }

  template <Scalar T, int K>
  static constexpr BoundedVertex<T, K> bounded(const ClipVolume& volume,
                                               const ClipVertex<T, K>& v) {
    BoundedVertex<T, K> r{v, {}, kPlanes + volume.clip_distances};
    for (int p = 0; p < r.planes; ++p) {
      r.boundary[static_cast<std::size_t>(p)] =
          signed_distance(volume.depth, static_cast<Plane>(p), v);
    }
    return r;
  }

  template <Scalar T, int K>
  static constexpr Outcode outcode(const BoundedVertex<T, K>& v) {
    Outcode code = 0;
    for (const Plane plane : kAllPlanes) {
      if (!(T(0) <= v.boundary[static_cast<std::size_t>(plane)])) code |= bit(plane);
    }
    return code;
  }

  template <Scalar T, int K>
  static constexpr BoundedVertex<T, K> meet(const BoundedVertex<T, K>& inside,
                                            const BoundedVertex<T, K>& outside, const T& t) {
    BoundedVertex<T, K> r{interpolate(inside, outside, t), {}, inside.planes};
    for (std::size_t p = 0; p < static_cast<std::size_t>(r.planes); ++p) {
      r.boundary[p] = inside.boundary[p] + t * (outside.boundary[p] - inside.boundary[p]);
    }
    return r;
  }
};

}  // namespace clipscope

// SPDX-License-Identifier: MIT
//
// The correctly rounded clipper: the distance-matrix clipper with every decision exact and every
// coordinate the float nearest to the exact one.
//
// For triangles of floats in clip space (w of any sign) or in view space, with the exact numbers of
// the frustum instead of a rounded matrix, of any finite exponents:
//   - the vertices are those of the exact intersection of triangle and closed volume;
//   - x, y, z in NDC, 1/w and each attribute are the floats nearest to the exact values, ties to
//     even; subnormal ones are rounded once, and only what rounds to infinity is infinite.
// Hence the answer depends on the triangle's exact shape alone: to the bit it is the same whichever
// vertex is first, along an edge whichever triangle is clipped, and for positions times 2^k as long
// as these neither over- nor underflow (1/w apart, which is divided by it).
//
// Degenerate answers: a polygon of fewer than three corners is nothing; vertices with w = 0 (in the
// closed volume only (0, 0, 0, 0), with depth clamp (0, 0, z, 0) as well) are left out. Where a
// triangle has no area in NDC, some corners may be one point there, with other attributes; all
// of them are kept, so that the order of the input shows in nothing. With depth clamp z may round
// to infinity: then nothing comes out.
// Attributes that are not finite are interpolated in double without a promise; a triangle that is
// cut by a clip distance that is not finite yields nothing.
//
// `cut` rounds likewise, in clip coordinates: dividing its polygon rounds again.
//
// Source: this project; of the parts, see distance_matrix.hpp, exact_corners.hpp and
// exact_lines.hpp. Does not guarantee: anything in other rounding modes than to nearest, or with
// subnormals flushed.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "spaces/barycentric/exact_corners.hpp"
#include "spaces/barycentric/exact_lines.hpp"
#include "spaces/barycentric/exact_view.hpp"
#include "spaces/clipper.hpp"
#include "spaces/planes.hpp"
#include "spaces/polygon.hpp"

namespace clipscope {

struct CorrectlyRounded {
  static constexpr std::string_view name = "barycentric/correctly_rounded";
  static constexpr std::string_view summary =
      "the distance matrix with exact decisions; every coordinate is the float nearest to the truth";
  static constexpr std::string_view source = "this project";
  // x, y, z and 1/w are rounded once each: x w and so on are off by 2 u M at most, w by one, and so
  // is each of at most 32 attributes. As a distance, sqrt(3 * 2^2 + 1 + 32) < 7.
  static constexpr Promise promise{
      .ulps = 7, .watertight = true, .confined = true, .correctly_rounded = true};

  // `count` is called with the barycentric::Stage that settled each sign and quotient.
  // Pre-condition: is_valid(projection.frustum), and the volume has its depth range.
  template <int K, class Count = barycentric::CountNothing>
  void operator()(const Projection<float>& projection, const ViewTriangle<float, K>& triangle,
                  NdcPolygon<float, K>& out, Count&& count = {}) const {
    out.clear();
    if (!has_finite_positions(triangle)) return;
    const Frustum<float>& frustum = projection.frustum;
    const barycentric::ViewRows rows = barycentric::view_rows(frustum, triangle);
    barycentric::CutTriangle cut;
    if (!barycentric::cut_view_triangle(projection.volume, triangle, rows, cut, count)) return;
    fill(cut.corners, barycentric::ViewPoints(frustum, rows, triangle), triangle, out, count);
  }

  template <int K, class Count = barycentric::CountNothing>
  void operator()(const ClipVolume& volume, const ClipTriangle<float, K>& triangle,
                  NdcPolygon<float, K>& out, Count&& count = {}) const {
    out.clear();
    const Coordinates coordinates = barycentric::clip_coordinates(triangle);
    barycentric::CutTriangle cut;
    if (!barycentric::cut_clip_triangle(volume, triangle, coordinates, cut, count)) return;
    fill(cut.corners, barycentric::ClipPoints(volume.depth, coordinates), triangle, out, count);
  }

  // The polygon in clip coordinates: x, y, z, w and the attributes at the points of the triangle,
  // sum lambda_i p_i / sum lambda_i, are the floats nearest to the exact values. On the planes
  // x = -w, x = w and so on hold to the bit, and z = +0 where the bound is 0.
  // Vertices of the triangle come out as they are, bit for bit. The vertices are those of the
  // polygon in NDC, all with an exact w > 0, which may round to 0. Nothing overflows, since all
  // lies between the vertices of the triangle.
  template <int K, class Count = barycentric::CountNothing>
  static ClipPolygon<float, K> cut(const ClipVolume& volume, const ClipTriangle<float, K>& triangle,
                                   Count&& count = {}) {
    ClipPolygon<float, K> out;
    const Coordinates coordinates = barycentric::clip_coordinates(triangle);
    barycentric::CutTriangle cut;
    if (!barycentric::cut_clip_triangle(volume, triangle, coordinates, cut, count)) return out;
    const barycentric::ClipPoints points(volume.depth, coordinates);
    for (const barycentric::Corner& corner : cut.corners) {
      if (side(corner.at, points.w(), count) <= 0) continue;
      if (const int own = barycentric::own_vertex(corner.at); own >= 0) {
        out.push_back(triangle[own]);
        continue;
      }
      const barycentric::Divisor sum = divisor(corner.at, barycentric::kOnes);
      ClipVertex<float, K> v;
      v.position = points.clip_position(corner.at, sum, count);
      set_attributes(corner.at, sum, triangle, v.attributes, count);
      out.push_back(v);
    }
    out.drop_if_degenerate();
    return out;
  }

  // The stages that settle a batch. Where: the projection of view-space triangles, or a volume.
  template <class Where, class AnyTriangle>
  static barycentric::CountStages count_stages(const Where& where,
                                               std::span<const AnyTriangle> triangles) {
    barycentric::CountStages count;
    using Vertex = typename AnyTriangle::value_type;
    NdcPolygon<float, attribute_count(static_cast<const Vertex*>(nullptr))> out;
    for (const AnyTriangle& triangle : triangles) CorrectlyRounded{}(where, triangle, out, count);
    return count;
  }

 private:
  template <Space S, int K>
  static constexpr int attribute_count(const clipscope::Vertex<S, float, K>*) {
    return K;
  }

  using Coordinates = std::array<barycentric::Values, 4>;  // x, y, z, w

  // The corners with w > 0 in NDC.
  template <Space S, int K, class Points, class Count>
  static void fill(const barycentric::Corners& corners, const Points& points,
                   const Triangle<S, float, K>& triangle, NdcPolygon<float, K>& out, Count& count) {
    for (const barycentric::Corner& corner : corners) {
      if (side(corner.at, points.w(), count) <= 0) continue;
      NdcVertex<float, K> v;
      v.position = points.position(corner.at, count);
      set_attributes(corner.at, divisor(corner.at, barycentric::kOnes), triangle, v.attributes,
                     count);
      out.push_back(v);
    }
    out.drop_if_degenerate();
    clear_if_overflowed(out);
  }
};

}  // namespace clipscope

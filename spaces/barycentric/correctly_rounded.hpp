// SPDX-License-Identifier: MIT
//
// The correctly rounded clipper: the distance-matrix clipper with every decision exact and every
// coordinate the float nearest to the exact one.
//
// For clip-space triangles of floats (w of any sign, any finite exponents):
//   - the vertices are those of the exact intersection of triangle and closed volume;
//   - x, y, z in NDC, 1/w and each attribute are the floats nearest to the exact values, ties to
//     even; subnormal ones are rounded once, and only what rounds to infinity is infinite.
// Hence the answer depends on the triangle's exact shape alone: to the bit it is the same whichever
// vertex is first, along an edge whichever triangle is clipped, and for positions times 2^k as long as
// these neither over- nor underflow (1/w apart, which is divided by it).
//
// Degenerate answers: a polygon of fewer than three vertices is nothing; vertices with w = 0 (in the
// closed volume only (0, 0, 0, 0), with depth clamp (0, 0, z, 0) as well) are left out; vertices that
// coincide in NDC count once, and the attributes are those of the first. That happens for triangles
// without an area in NDC alone, and is the one case where the order of the input shows. With depth
// clamp z may round to infinity: then nothing comes out.
// Attributes that are not finite are interpolated in double without a promise; a triangle that is cut
// by a clip distance that is not finite yields nothing.
//
// The stage before the divide is there as well: the polygon in clip coordinates, rounded likewise.
//
// Source: this project; of the parts, see distance_matrix.hpp, exact_corners.hpp and exact_lines.hpp.
// Does not guarantee: anything in other rounding modes than to nearest, or with subnormals flushed.
// View-space input isn't taken: its transform would be rounded first. It is not in `AllClippers` for
// that reason.
#pragma once

#include <array>
#include <string_view>

#include "spaces/barycentric/exact_corners.hpp"
#include "spaces/barycentric/exact_lines.hpp"
#include "spaces/clipper.hpp"
#include "spaces/planes.hpp"
#include "spaces/polygon.hpp"

namespace clipscope {

struct CorrectlyRounded {
  static constexpr std::string_view name = "barycentric/correctly_rounded";
  static constexpr std::string_view summary =
      "the distance matrix with exact decisions; every coordinate is the float nearest to the "
      "truth";
  static constexpr std::string_view source = "this project";
  // x/w and 1/w are rounded, once each.
  static constexpr Promise promise{.ulps = 2, .watertight = true};

  // `count` is called with the barycentric::Stage that settled each sign and quotient.
  template <int K, class Count = barycentric::CountNothing>
  void operator()(const ClipVolume& volume, const ClipTriangle<float, K>& triangle,
                  NdcPolygon<float, K>& out, Count&& count = {}) const {
    out.clear();
    const Coordinates coordinates = barycentric::clip_coordinates(triangle);
    barycentric::CutTriangle cut;
    if (!barycentric::cut_clip_triangle(volume, triangle, coordinates, cut, count)) return;
    append_vertices(volume.depth, cut.corners, coordinates, triangle, out, count);
    out.drop_if_degenerate();
    clear_if_overflowed(out);
  }

  // The polygon in clip coordinates: x, y, z, w and the attributes at the points of the triangle,
  // sum lambda_i p_i / sum lambda_i, are the floats nearest to the exact values. On the planes
  // x = -w, x = w and so on hold to the bit, and z = +0 where the bound is 0.
  // Vertices of the triangle come out as they are, bit for bit.
  // The vertices are those with an exact w > 0; w may round to 0. If the triangle has no area in NDC,
  // some may be one point there. Fewer than three vertices are nothing. Nothing overflows, since all
  // lies between the vertices of the triangle.
  template <int K, class Count = barycentric::CountNothing>
  static void stage(const ClipVolume& volume, const ClipTriangle<float, K>& triangle,
                    ClipPolygon<float, K>& out, Count&& count = {}) {
    out.clear();
    const Coordinates coordinates = barycentric::clip_coordinates(triangle);
    barycentric::CutTriangle cut;
    if (!barycentric::cut_clip_triangle(volume, triangle, coordinates, cut, count)) return;
    const Line w{coordinates[3], {}, 0};
    for (const Corner& corner : cut.corners) {
      if (side(corner.at, w, count) <= 0) continue;
      if (const int own = barycentric::own_vertex(corner.at); own >= 0) {
        out.push_back(triangle[own]);
        continue;
      }
      const barycentric::Divisor sum = divisor(corner.at, barycentric::kOnes);
      ClipVertex<float, K> v;
      v.position = clip_position(volume.depth, corner.at, coordinates, sum, count);
      set_attributes(corner.at, sum, triangle, v.attributes, count);
      out.push_back(v);
    }
    out.drop_if_degenerate();
  }

 private:
  using Line = barycentric::Line;
  using Meeting = barycentric::Meeting;
  using Corner = barycentric::Corner;
  using Corners = barycentric::Corners;
  using Coordinates = std::array<barycentric::Values, 4>;  // x, y, z, w

  template <int K, class Count>
  static void append_vertices(DepthRange depth, const Corners& corners,
                              const Coordinates& coordinates,
                              const ClipTriangle<float, K>& triangle, NdcPolygon<float, K>& out,
                              Count& count) {
    const Line w{coordinates[3], {}, 0};
    std::array<const Meeting*, kMaxPolygonVertices> kept;
    for (const Corner& corner : corners) {
      if (side(corner.at, w, count) <= 0) continue;
      NdcVertex<float, K> v;
      v.position = ndc_position(depth, corner.at, coordinates, count);
      const auto coincides = [&](int i) {
        return have_same_coordinates(out[i].position, v.position) &&
               coincide(*kept[i], corner.at, coordinates);
      };
      bool seen = false;
      for (int i = 0; i < out.size() && !seen; ++i) seen = coincides(i);
      if (seen) continue;
      set_attributes(corner.at, divisor(corner.at, barycentric::kOnes), triangle, v.attributes,
                     count);
      kept[out.size()] = &corner.at;
      out.push_back(v);
    }
  }

  // Calls f(axis, bound) for each of the six planes that the meeting lies on: there c = bound w.
  template <class F>
  static void for_each_fixed(DepthRange depth, const Meeting& m, F&& f) {
    for_each_plane(planes_of(m) & kSixPlanes, kAllPlanes, [&](Plane plane) {
      const auto [axis, bound] = barycentric::plane_form(depth, plane);
      f(axis, bound);
    });
  }
  static constexpr Outcode kSixPlanes = (Outcode{1} << kPlanes) - 1;

  template <class Count>
  static Vec4<float> ndc_position(DepthRange depth, const Meeting& m,
                                  const Coordinates& coordinates, Count& count) {
    const barycentric::Divisor w = divisor(m, coordinates[3]);
    Vec4<float> r;
    std::array<bool, 3> is_set{};
    for_each_fixed(depth, m, [&](int axis, float bound) {
      r[axis] = bound;
      is_set[axis] = true;
    });
    for (int c = 0; c < 3; ++c) {
      if (!is_set[c]) r[c] = rounded_quotient(m, coordinates[c], w, count);
    }
    r[3] = rounded_quotient(m, barycentric::kOnes, w, count);
    return r;
  }

  template <class Count>
  static Vec4<float> clip_position(DepthRange depth, const Meeting& m,
                                   const Coordinates& coordinates, const barycentric::Divisor& sum,
                                   Count& count) {
    Vec4<float> r;
    r[3] = rounded_quotient(m, coordinates[3], sum, count);
    std::array<bool, 3> is_set{};
    for_each_fixed(depth, m, [&](int axis, float bound) {
      r[axis] = bound == 0 ? 0 : bound * r[3];
      is_set[axis] = true;
    });
    for (int c = 0; c < 3; ++c) {
      if (!is_set[c]) r[c] = rounded_quotient(m, coordinates[c], sum, count);
    }
    return r;
  }

  static bool have_same_coordinates(const Vec4<float>& a, const Vec4<float>& b) {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
  }

  // Whether two points are the same in NDC, exactly.
  static bool coincide(const Meeting& a, const Meeting& b, const Coordinates& coordinates) {
    for (int c = 0; c < 3; ++c) {
      if (!has_same_quotient(a, b, coordinates[c], coordinates[3])) return false;
    }
    return true;
  }
};

}  // namespace clipscope

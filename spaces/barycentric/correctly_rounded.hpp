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
// Source: this project; of the parts, see distance_matrix.hpp and exact_lines.hpp.
// Does not guarantee: anything in other rounding modes than to nearest, or with subnormals flushed.
// View-space input isn't taken: its transform would be rounded first. It is not in `AllClippers` for
// that reason.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <tuple>
#include <utility>

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
    if (!has_finite_positions(triangle)) return;
    const OutcodeSummary code = summarize_outcodes(volume, triangle, [&](std::size_t i) {
      return clip_outcode(volume.depth, triangle[i].position);
    });
    if (code.all != 0 || !has_finite_distances(code.any, triangle)) return;

    std::array<Line, 3> edges;  // edge i is opposite to vertex i
    for (int i = 0; i < 3; ++i) edges[i].rounded[i] = 1;
    Corners corners, other;
    for (int i = 0; i < 3; ++i) {
      const Line &before = edges[(i + 1) % 3], &after = edges[(i + 2) % 3];
      corners.push_back({meet(before, after), &after});
    }
    std::array<Line, kMaxPlanes> rows;
    for_each_plane(code.any, kAllPlanes, [&](Plane plane) {
      if (corners.size() < 3) return;  // a point or a segment never grows
      Line& line = rows[static_cast<int>(plane)];
      line = row(volume.depth, plane, triangle);
      cut_corners(corners, line, other, count);
      std::swap(corners, other);
    });
    if (corners.size() < 3) return;
    append_vertices(volume.depth, corners, triangle, out, count);
    out.drop_if_degenerate();
    clear_if_overflowed(out);
  }

 private:
  using Line = barycentric::Line;
  using Meeting = barycentric::Meeting;
  using Values = barycentric::Values;

  // A vertex, and the line from it to the next one.
  struct Corner {
    Meeting at;
    const Line* next;
  };
  using Corners = VertexList<Corner>;

  // A plane of the volume is w - bound c >= 0, and c >= 0 if bound is 0, where c is coordinate
  // `axis`: on it c / w = bound.
  struct PlaneForm {
    int axis;
    float bound;
  };
  static constexpr PlaneForm form(DepthRange depth, Plane plane) {
    const int p = static_cast<int>(plane), axis = p / 2;
    const bool is_z = axis == 2;
    const bool is_upper = (p % 2 != 0) != (is_z && depth == DepthRange::reversed);
    if (is_upper) return {axis, 1};
    return {axis, is_z && depth != DepthRange::minus_one_to_one ? 0.0f : -1.0f};
  }

  template <int K>
  static bool has_finite_distances(Outcode planes, const ClipTriangle<float, K>& triangle) {
    for (int i = 0; (planes >> (kPlanes + i)) != 0; ++i) {
      if ((planes >> (kPlanes + i) & 1) == 0) continue;
      for (const ClipVertex<float, K>& v : triangle) {
        if (!is_finite(v.attributes[i])) return false;
      }
    }
    return true;
  }

  // A row of the distance matrix, exact.
  template <int K>
  static Line row(DepthRange depth, Plane plane, const ClipTriangle<float, K>& triangle) {
    Line r{{}, {}, bit(plane)};
    for (int i = 0; i < 3; ++i) {
      if (is_clip_distance(plane)) {
        r.rounded[i] = triangle[i].attributes[clip_distance_index(plane)];
        continue;
      }
      const auto [axis, bound] = form(depth, plane);
      const double c = triangle[i].position[axis], w = triangle[i].position[3];
      if (bound == 0) {
        r.rounded[i] = c;
      } else {
        std::tie(r.rounded[i], r.error[i]) = bounds::two_sum(w, -bound * c);
      }
    }
    return r;
  }

  // The corners on the line's inner side and the meetings of the polygon's lines with it: Sutherland
  // and Hodgman. The polygon is strictly convex in the barycentric plane and is walked in the order of
  // the triangle, so that at each corner the lines turn one way and lambda, as `meet` has it, is
  // positive.
  template <class Count>
  static void cut_corners(const Corners& in, const Line& line, Corners& out, Count& count) {
    std::array<int, kMaxPolygonVertices> sides;
    for (int i = 0; i < in.size(); ++i) sides[i] = side(in[i].at, line, count);
    out.clear();
    for (int i = 0; i < in.size(); ++i) {
      const Corner& from = in[i];
      const int here = sides[i], next = sides[(i + 1) % in.size()];
      if (here >= 0) out.push_back({from.at, here == 0 && next < 0 ? &line : from.next});
      if (here > 0 && next < 0) {
        out.push_back({meet(*from.next, line), &line});
      } else if (here < 0 && next > 0) {
        out.push_back({meet(line, *from.next), from.next});
      }
    }
  }

  template <int K, class Count>
  static void append_vertices(DepthRange depth, const Corners& corners,
                              const ClipTriangle<float, K>& triangle, NdcPolygon<float, K>& out,
                              Count& count) {
    std::array<Values, 4> positions;
    for (int c = 0; c < 4; ++c) {
      for (int i = 0; i < 3; ++i) positions[c][i] = triangle[i].position[c];
    }
    const Line w{positions[3], {}, 0};
    std::array<const Meeting*, kMaxPolygonVertices> kept;
    for (const Corner& corner : corners) {
      if (side(corner.at, w, count) <= 0) continue;
      NdcVertex<float, K> v;
      v.position = ndc_position(depth, corner.at, positions, count);
      const auto coincides = [&](int i) {
        return have_same_coordinates(out[i].position, v.position) &&
               coincide(*kept[i], corner.at, positions);
      };
      bool seen = false;
      for (int i = 0; i < out.size() && !seen; ++i) seen = coincides(i);
      if (seen) continue;
      set_attributes(corner.at, triangle, v.attributes, count);
      kept[out.size()] = &corner.at;
      out.push_back(v);
    }
  }

  static constexpr Plane clip_distance(int i) { return static_cast<Plane>(kPlanes + i); }
  static constexpr Values kOnes = {1, 1, 1};

  template <class Count>
  static Vec4<float> ndc_position(DepthRange depth, const Meeting& m,
                                  const std::array<Values, 4>& positions, Count& count) {
    const barycentric::Divisor w = divisor(m, positions[3]);
    Vec4<float> r;
    std::array<bool, 3> is_set{};
    for_each_plane((m.a->plane | m.b->plane) & kSixPlanes, kAllPlanes, [&](Plane plane) {
      const auto [axis, bound] = form(depth, plane);
      r[axis] = bound;
      is_set[axis] = true;
    });
    for (int c = 0; c < 3; ++c) {
      if (!is_set[c]) r[c] = rounded_quotient(m, positions[c], w, count);
    }
    r[3] = rounded_quotient(m, kOnes, w, count);
    return r;
  }
  static constexpr Outcode kSixPlanes = (Outcode{1} << kPlanes) - 1;

  template <int K, class Count>
  static void set_attributes(const Meeting& m, const ClipTriangle<float, K>& triangle,
                             Attributes<float, K>& out, Count& count) {
    const barycentric::Divisor sum = divisor(m, kOnes);
    out.resize(triangle[0].attributes.size());
    for (int k = 0; k < out.size(); ++k) {
      if (k < kMaxClipDistances && ((m.a->plane | m.b->plane) & bit(clip_distance(k))) != 0) {
        out[k] = 0;
        continue;
      }
      Values a{};  // a vertex without weight takes no part, whatever its attribute
      for (int i = 0; i < 3; ++i) {
        if (m.magnitude[i] != 0) a[i] = triangle[i].attributes[k];
      }
      if (is_finite(a[0] + a[1] + a[2])) {
        out[k] = rounded_quotient(m, a, sum, count);
      } else {
        out[k] = static_cast<float>(dot(m, a).value / sum.dot.value);
      }
    }
  }

  static bool have_same_coordinates(const Vec4<float>& a, const Vec4<float>& b) {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
  }

  // Whether two points are the same in NDC, exactly.
  static bool coincide(const Meeting& a, const Meeting& b, const std::array<Values, 4>& positions) {
    for (int c = 0; c < 3; ++c) {
      if (!has_same_quotient(a, b, positions[c], positions[3])) return false;
    }
    return true;
  }
};

}  // namespace clipscope

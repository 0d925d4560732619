// SPDX-License-Identifier: MIT
//
// McGuire's register-only Sutherland-Hodgman: a triangle or a quadrilateral against one plane, in
// place and by cases.
//
// The vertices are cycled in place until the first one inside after one outside comes first: a
// compare and a few moves instead of a loop with a list that grows. The edge from there back to the
// last vertex is then always cut, and the number of vertices inside names the one other edge that
// is. No vertex is addressed by a computed index, so that all of them may live in registers.
// Source: McGuire, "Efficient Triangle and Quadrilateral Clipping within Shaders", Journal of
// Graphics, GPU, and Game Tools 15(4), 2011, and its clip.glsl, functions clip3 and clip4.
// Left out: the tolerances of clip.glsl, which drop a triangle that reaches less than 0.01 into the
// plane and keep one that reaches less than 0.00001 out: they lose visible parts, and the contract
// has no unit. Repaired: a vertex on the plane makes no second copy of itself, as in cut.hpp; where
// rounding has torn the inside into several runs, which the cases do not know, or a segment is left
// of the triangle, the step of cut.hpp cuts.
// Added: the planes one after the other, chosen by outcodes; what has five vertices or more, of
// which the paper does not speak, is cycled and cut by the same rule in a loop.
// Guarantees: the bits of homogeneous/sutherland_hodgman, as long as nothing overflows.
// Does not guarantee: coordinates within the volume to the last bit after the divide; the exact
// vertex count where a vertex comes within rounding of a plane.
#pragma once

#include "spaces/homogeneous/by_outcodes.hpp"

namespace clipscope {

struct HomogeneousMcGuire : CutsByOutcodes<HomogeneousMcGuire> {
  static constexpr std::string_view name = "homogeneous/mcguire";
  static constexpr std::string_view summary =
      "Sutherland-Hodgman in clip space by cases, in place: a triangle or quadrilateral in registers";
  static constexpr std::string_view source =
      "McGuire, Efficient Triangle and Quadrilateral Clipping within Shaders, 2011";
  static constexpr Promise promise{.ulps = kChainUlps, .watertight = true};

  using CutsByOutcodes<HomogeneousMcGuire>::cut;

  template <class V>
  static constexpr const VertexList<V>& cut(const ClipVolume& volume, Outcode planes,
                                            VertexList<V>& polygon, VertexList<V>& scratch) {
    clear_unless_finite(polygon);
    for_each_plane(planes, kNearFirst, [&](Plane plane) {
      const auto d = [&](int i) { return signed_distance(volume.depth, plane, polygon[i]); };
      bool is_cut = false;
      if (polygon.size() == 3) {
        is_cut = clip3(polygon, std::array{d(0), d(1), d(2)});
      } else if (polygon.size() == 4) {
        is_cut = clip4(polygon, std::array{d(0), d(1), d(2), d(3)});
      } else if (polygon.size() > 4) {
        is_cut = clip_more(volume.depth, plane, polygon, scratch);
      }
      if (!is_cut) {
        scratch = polygon;
        clipscope::cut(scratch, polygon,
                       [&](const V& v) { return signed_distance(volume.depth, plane, v); });
      }
    });
    return polygon;
  }

 private:
  // The polygon after a cut: `kept` vertices that come first are inside; edge_out and edge_in are
  // the new vertices on the edges that leave the inside and enter it, d_last and d_first the
  // distances of their inside ends. A vertex on the plane is the new vertex itself.
  template <class V, Scalar T>
  static constexpr void finish(VertexList<V>& v, int kept, const V& edge_out, const T& d_last,
                               const V& edge_in, const T& d_first) {
    v.truncate(kept);
    if (T(0) < d_last) v.push_back(edge_out);
    if (T(0) < d_first) v.push_back(edge_in);
  }

  // Makes vertex and distance kFirst the first of the kSize, the others behind it in their order.
  template <int kFirst, int kSize, class V, Scalar T>
  static constexpr void cycle(VertexList<V>& v, std::array<T, kSize>& d) {
    std::array<V, kSize> vertices;
    for (int i = 0; i < kSize; ++i) vertices[i] = v[(i + kFirst) % kSize];
    for (int i = 0; i < kSize; ++i) v[i] = vertices[i];
    const std::array<T, kSize> distances = d;
    for (int i = 0; i < kSize; ++i) d[i] = distances[(i + kFirst) % kSize];
  }

  template <class V, Scalar T>
  static constexpr bool clip3(VertexList<V>& v, std::array<T, 3> d) {
    const bool above[3] = {T(0) <= d[0], T(0) <= d[1], T(0) <= d[2]};
    if (!above[0] && !above[1] && !above[2]) v.clear();
    if (above[0] == above[1] && above[1] == above[2]) return true;
    bool next_is_above = above[1];
    if (above[1] && !above[0]) {
      next_is_above = above[2];
      cycle<1, 3>(v, d);
    } else if (above[2] && !above[1]) {
      next_is_above = above[0];
      cycle<2, 3>(v, d);
    }
    // The edge from v0 back to v2 is always cut.
    const V edge_in = meeting(v[0], v[2], d[0], d[2]);
    if (next_is_above) {
      finish(v, 2, meeting(v[1], v[2], d[1], d[2]), d[1], edge_in, d[0]);
    } else {
      finish(v, 1, meeting(v[0], v[1], d[0], d[1]), d[0], edge_in, d[0]);
    }
    return true;
  }

  // Whether the vertices inside are one run; if not nothing is cut.
  template <class V, Scalar T>
  static constexpr bool clip4(VertexList<V>& v, std::array<T, 4> d) {
    const bool above[4] = {T(0) <= d[0], T(0) <= d[1], T(0) <= d[2], T(0) <= d[3]};
    const int count = above[0] + above[1] + above[2] + above[3];
    if (count == 0) v.clear();
    if (count == 0 || count == 4) return true;
    if (count == 2 && above[0] == above[2]) return false;
    if (above[1] && !above[0]) {
      cycle<1, 4>(v, d);
    } else if (above[2] && !above[1]) {
      cycle<2, 4>(v, d);
    } else if (above[3] && !above[2]) {
      cycle<3, 4>(v, d);
    }
    // The edge from v0 back to v3 is always cut, and one of the other three.
    const V edge_in = meeting(v[0], v[3], d[0], d[3]);
    switch (count) {
      case 1: finish(v, 1, meeting(v[0], v[1], d[0], d[1]), d[0], edge_in, d[0]); break;
      case 2: finish(v, 2, meeting(v[1], v[2], d[1], d[2]), d[1], edge_in, d[0]); break;
      default: finish(v, 3, meeting(v[2], v[3], d[2], d[3]), d[2], edge_in, d[0]);
    }
    return true;
  }

  // The same for five vertices or more.
  template <class V>
  static constexpr bool clip_more(DepthRange depth, Plane plane, VertexList<V>& v,
                                  VertexList<V>& scratch) {
    using T = decltype(signed_distance(depth, plane, v[0]));
    const int n = v.size();
    std::array<T, kMaxPolygonVertices> d{};
    std::array<bool, kMaxPolygonVertices> above{};
    int count = 0, runs = 0, first = 0;
    for (int i = 0; i < n; ++i) {
      d[i] = signed_distance(depth, plane, v[i]);
      above[i] = T(0) <= d[i];
      count += above[i];
    }
    if (count == 0) v.clear();
    if (count == 0 || count == n) return true;
    for (int i = 0; i < n; ++i) {
      if (!above[i] || above[(i + n - 1) % n]) continue;
      first = i;
      ++runs;
    }
    if (runs > 1) return false;
    scratch.clear();
    for (int i = 0; i < count; ++i) scratch.push_back(v[(first + i) % n]);
    const int last = (first + count - 1) % n, after = (last + 1) % n, before = (first + n - 1) % n;
    finish(scratch, count, meeting(v[last], v[after], d[last], d[after]), d[last],
           meeting(v[first], v[before], d[first], d[before]), d[first]);
    v = scratch;
    return true;
  }
};

}  // namespace clipscope

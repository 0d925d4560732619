// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is left of a shared edge in the polygons of its two triangles: the same bits, or a gap.
//
// The vertices of a polygon that lie on an edge are found by marks, as attributes: attribute k is 0 at the
// corners of edge k (the one opposite to corner k) and a mark at corner k. Every clipper interpolates 0
// and 0 to 0, and NaN marks whatever it touches. A barycentric clipper multiplies the mark by 0 on the
// edge, so there it is 1: its weight of corner k is exactly 0 on the edge, and not 0 off it.
//
// Distances are computed in double from differences taken in the clipper's scalar: they are right to
// 1e-12 px (2^-52 of a coordinate up to 1, times half of 3840 px), and 0 where the bits are the same.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "experiments/contestants/scalars.hpp"
#include "experiments/measure/batches.hpp"
#include "experiments/measure/outcome.hpp"
#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

// The last attribute stays free: it is compared along with the position.
inline constexpr int kCarried = 3;

template <class T>
T edge_mark(std::string_view clipper) {
  if (kHasInfinity<T> && !clipper.starts_with("barycentric/")) {
    return T(std::numeric_limits<float>::quiet_NaN());
  }
  return T(1);
}

// The triangle with its three edges marked. As carried attribute it has its x coordinate: whatever
// neighbours have in common depends on the position alone.
template <class T>
ViewTriangle<T, kSceneAttributes> marked(const SceneTriangle& triangle, const T& mark) {
  auto result = simplex_cast<T>(triangle);
  for (std::size_t i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) result[i].attributes[k] = T(0);
    result[i].attributes[static_cast<int>(i)] = mark;
    result[i].attributes[kCarried] = result[i].position[0];
  }
  return result;
}

template <class T>
using EdgeVertices = std::vector<const NdcVertex<T, kSceneAttributes>*>;

template <class T>
bool same_bits(const NdcVertex<T, kSceneAttributes>& a, const NdcVertex<T, kSceneAttributes>& b) {
  return a.position == b.position && a.attributes[kCarried] == b.attributes[kCarried];
}

template <class T>
bool holds(const EdgeVertices<T>& vertices, const NdcVertex<T, kSceneAttributes>& v) {
  return std::any_of(vertices.begin(), vertices.end(),
                     [&](const auto* u) { return same_bits(*u, v); });
}

// The distinct vertices of a marked triangle's polygon that lie on the edge opposite to a corner.
template <class T>
EdgeVertices<T> on_edge(std::span<const NdcVertex<T, kSceneAttributes>> polygon, int opposite) {
  EdgeVertices<T> result;
  for (const auto& v : polygon) {
    if (v.attributes[opposite] == T(0) && !holds(result, v)) result.push_back(&v);
  }
  return result;
}

// Nothing is left of a triangle whose polygon is empty, or flat: all of its vertices on the edge. It is
// where less is visible of it than rounding can tell.
struct EdgeGap {
  bool identical = false;  // the same vertices, bit for bit: x, y, z, 1/w and an attribute
  bool absent = false;     // identical, since neither polygon has anything of the edge
  bool lost = false;       // nothing is left of one triangle, while the other one has the edge
  int t_junctions = 0;     // vertices on the edge without a partner in the other polygon; 0 if lost
  double lost_px = 0;      // how long the piece is that only one side has; 0 if it is a point
  double crack_px = 0;  // largest distance from such a vertex to the outline of the other polygon
  std::array<double, 2> at = {0, 0};  // that vertex: x, y in NDC
};

// From one vertex to another, px on a screen of 3840 x 2160.
struct Offset {
  double x = 0, y = 0;
  double length() const { return std::hypot(x, y); }
};

template <class T>
Offset offset(const NdcVertex<T, kSceneAttributes>& from,
              const NdcVertex<T, kSceneAttributes>& to) {
  const T x = to.position[0] - from.position[0], y = to.position[1] - from.position[1];
  return {nearest_double(x) * kScreenWidth / 2, nearest_double(y) * kScreenHeight / 2};
}

// From the point of segment a-b that is nearest to p, to p.
template <class T>
Offset offset_from_segment(const NdcVertex<T, kSceneAttributes>& a,
                           const NdcVertex<T, kSceneAttributes>& b,
                           const NdcVertex<T, kSceneAttributes>& p) {
  const Offset ap = offset(a, p), ab = offset(a, b);
  const double square = ab.x * ab.x + ab.y * ab.y;
  const double along = ap.x * ab.x + ap.y * ab.y;
  if (!(along > 0)) return ap;
  if (along >= square) return offset(b, p);
  const double t = along / square;
  return {ap.x - t * ab.x, ap.y - t * ab.y};
}

// From the nearest point of a polygon's outline to p.
template <class T>
double distance_to_outline(std::span<const NdcVertex<T, kSceneAttributes>> polygon,
                           const NdcVertex<T, kSceneAttributes>& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& next = polygon[(i + 1) % polygon.size()];
    nearest = std::min(nearest, offset_from_segment(polygon[i], next, p).length());
  }
  return nearest;
}

// A marked triangle's polygon, and the corner opposite to the edge.
template <class T>
struct EdgeSide {
  std::span<const NdcVertex<T, kSceneAttributes>> polygon;
  int opposite = 0;
  double width_px = 0;  // how far from the edge it should reach, see CutEdge

  bool is_gone() const {
    return std::all_of(polygon.begin(), polygon.end(),
                       [&](const auto& v) { return v.attributes[opposite] == T(0); });
  }
};

// Adds the vertices of one side that have no partner in the piece of the other.
template <class T>
void add_alone(const EdgeVertices<T>& piece, const EdgeVertices<T>& other_piece,
               const EdgeSide<T>& other, EdgeGap& gap) {
  for (const auto* v : piece) {
    if (holds(other_piece, *v)) continue;
    ++gap.t_junctions;
    const double distance = std::min(distance_to_outline(other.polygon, *v), other.width_px);
    if (distance <= gap.crack_px) continue;
    gap.crack_px = distance;
    gap.at = {nearest_double(v->position[0]), nearest_double(v->position[1])};
  }
}

template <class T>
EdgeGap edge_gap(const EdgeSide<T>& first, const EdgeSide<T>& second) {
  EdgeGap gap;
  const bool first_gone = first.is_gone(), second_gone = second.is_gone();
  if (first_gone && second_gone) {
    gap.identical = gap.absent = true;
    return gap;
  }
  const EdgeVertices<T> a = on_edge<T>(first.polygon, first.opposite);
  const EdgeVertices<T> b = on_edge<T>(second.polygon, second.opposite);
  if (first_gone || second_gone) {
    const EdgeVertices<T>& kept = first_gone ? b : a;
    gap.lost = !kept.empty();
    gap.identical = gap.absent = kept.empty();
    if (gap.lost) gap.lost_px = first_gone ? first.width_px : second.width_px;
    return gap;
  }
  add_alone<T>(a, b, second, gap);
  add_alone<T>(b, a, first, gap);
  gap.identical = gap.t_junctions == 0;
  return gap;
}

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/watertight/shared_edges.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "experiments/measure/batches.hpp"
#include "experiments/measure/outcome.hpp"
#include "reference/exact_clip.hpp"

namespace clipscope::experiments {
namespace {

// For each position the index of the first one, in sorted order, that equals it.
std::vector<std::uint32_t> welded(const Mesh& mesh) {
  std::vector<std::uint32_t> order(mesh.positions.size()), first(mesh.positions.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return mesh.positions[a] < mesh.positions[b];
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && mesh.positions[order[i]] == mesh.positions[order[i - 1]];
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  return first;
}

// What is outside of a plane, and what lies on it.
struct Sides {
  Outcode outside = 0, on = 0;
};

Sides sides_of(const reference::Truth& truth, const reference::InputVertex& vertex) {
  Sides sides;
  const auto& half_spaces = truth.half_spaces();
  for (std::size_t p = 0; p < half_spaces.size(); ++p) {
    const int sign = reference::sign(half_spaces[p].form, vertex);
    sides.outside |= static_cast<Outcode>(sign < 0) << p;
    sides.on |= static_cast<Outcode>(sign == 0) << p;
  }
  return sides;
}

using TriangleSides = std::array<Sides, 3>;

Outcode planes_cutting(const TriangleSides& sides) {
  return sides[0].outside | sides[1].outside | sides[2].outside;
}

// The ends of the edge: the two corners that are not opposite to it.
std::pair<std::size_t, std::size_t> ends_of(int opposite) {
  const auto k = static_cast<std::size_t>(opposite);
  return {(k + 1) % 3, (k + 2) % 3};
}

// Whether the vertices alone leave it possible that clipping touches the edge.
bool may_be_touched(const TriangleSides& a, const TriangleSides& b, int opposite) {
  const auto [i, j] = ends_of(opposite);
  return (planes_cutting(a) | planes_cutting(b)) != 0 && (a[i].outside & a[j].outside) == 0 &&
         (a[i].on & a[j].on) == 0;
}

using Points = std::vector<std::array<double, 2>>;  // px

Points points_of(const reference::ExactPolygon& polygon) {
  Points points;
  for (const reference::ExactVertex& v : polygon.vertices) {
    points.push_back({reference::approximate(v.x) * kScreenWidth / 2,
                      reference::approximate(v.y) * kScreenHeight / 2});
  }
  return points;
}

// The visible part of the edge; less than two points if there is none.
Points visible_edge(const reference::Truth& truth, const SceneTriangle& triangle, int opposite) {
  const auto [i, j] = ends_of(opposite);
  const std::array ends = {reference::input_vertex(triangle[i]),
                           reference::input_vertex(triangle[j])};
  return points_of(reference::clip(truth, ends, 0));
}

// The largest distance of a visible point of the triangle from the line through two points.
double width_beside(const Points& edge, const reference::Truth& truth,
                    const SceneTriangle& triangle) {
  reference::InputTriangle input = reference::input_triangle(triangle);
  input.attribute_count = 0;
  const double x = edge[1][0] - edge[0][0], y = edge[1][1] - edge[0][1];
  const double length = std::hypot(x, y);
  double width = 0;
  for (const auto& p : points_of(reference::clip(truth, input))) {
    const double dx = p[0] - edge[0][0], dy = p[1] - edge[0][1];
    const double distance = length > 0 ? std::abs(dx * y - dy * x) / length : std::hypot(dx, dy);
    width = std::max(width, distance);
  }
  return width;
}

}  // namespace

std::vector<SharedEdge> shared_edges(const Mesh& mesh) {
  const std::vector<std::uint32_t> vertex = welded(mesh);
  // Its ends, the lower first, the triangle and the opposite corner.
  std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, int>> sides;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int opposite = 0; opposite < 3; ++opposite) {
      const auto [i, j] = ends_of(opposite);
      const std::uint32_t a = vertex[mesh.triangles[t][i]], b = vertex[mesh.triangles[t][j]];
      if (a != b) sides.emplace_back(std::min(a, b), std::max(a, b), t, opposite);
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<SharedEdge> edges;
  for (std::size_t first = 0, i = 1; i < sides.size(); ++i) {
    const auto& [a, b, triangle, opposite] = sides[first];
    const auto& [other_a, other_b, other_triangle, other_opposite] = sides[i];
    if (a != other_a || b != other_b) {
      first = i;
    } else if (triangle != other_triangle) {
      edges.push_back({{triangle, other_triangle}, {opposite, other_opposite}});
    }
  }
  return edges;
}

std::vector<CutEdge> cut_edges(const Scene& scene, const View& view,
                               const std::vector<SharedEdge>& edges, std::size_t limit) {
  const auto truth = reference::Truth::of_frustum(frustum_cast<double>(view.frustum));
  std::vector<SceneTriangle> triangles(scene.mesh.triangles.size());
  view_triangles(scene, view, 0, triangles);
  std::vector<TriangleSides> sides(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      sides[t][i] = sides_of(truth, reference::input_vertex(triangles[t][i]));
    }
  }
  std::vector<SharedEdge> candidates;
  for (const SharedEdge& e : edges) {
    if (may_be_touched(sides[e.triangles[0]], sides[e.triangles[1]], e.opposite[0])) {
      candidates.push_back(e);
    }
  }
  const std::size_t stride =
      limit == 0 ? 1 : std::max<std::size_t>(1, (candidates.size() + limit - 1) / limit);
  std::vector<CutEdge> result;
  for (std::size_t c = 0; c < candidates.size(); c += stride) {
    const SharedEdge& e = candidates[c];
    const SceneTriangle &first = triangles[e.triangles[0]], &second = triangles[e.triangles[1]];
    const Points visible = visible_edge(truth, first, e.opposite[0]);
    if (visible.size() != 2) continue;
    const TriangleSides &a = sides[e.triangles[0]], &b = sides[e.triangles[1]];
    const auto [i, j] = ends_of(e.opposite[0]);
    result.push_back({e,
                      a[i].outside | a[j].outside,
                      planes_cutting(a) != planes_cutting(b),
                      {width_beside(visible, truth, first), width_beside(visible, truth, second)}});
  }
  return result;
}

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/watertight/shared_edges.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/judge/match.hpp"
#include "experiments/scenes/mesh_edges.hpp"
#include "reference/exact_clip.hpp"

namespace clipscope::experiments::watertight {
namespace {

// The planes that each corner of a triangle is outside of, and those that it lies on.
struct Corners {
  std::array<Outcode, 3> outside{}, on{};

  Outcode cut_by() const { return outside[0] | outside[1] | outside[2]; }
};

Corners corners_of(const reference::Truth& truth, const SceneTriangle& triangle) {
  Corners corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const reference::InputVertex vertex = reference::input_vertex(triangle[i]);
    for (std::size_t p = 0; p < truth.half_spaces().size(); ++p) {
      const int sign = reference::sign(truth.half_spaces()[p].form, vertex);
      corners.outside[i] |= static_cast<Outcode>(sign < 0) << p;
      corners.on[i] |= static_cast<Outcode>(sign == 0) << p;
    }
  }
  return corners;
}

// Whether the vertices alone leave it possible that clipping touches the edge.
bool may_be_touched(const Corners& a, const Corners& b, int opposite) {
  const auto [i, j] = ends_of(opposite);
  return (a.cut_by() | b.cut_by()) != 0 && (a.outside[i] & a.outside[j]) == 0 &&
         (a.on[i] & a.on[j]) == 0;
}

// What is visible of an edge or a triangle; less than two points if nothing is.
std::vector<ScreenPoint> visible_part(const reference::Truth& truth,
                                      std::span<const reference::InputVertex> vertices) {
  std::vector<ScreenPoint> points;
  for (const reference::ExactVertex& v : reference::clip(truth, vertices, 0).vertices) {
    points.push_back(screen_point(reference::approximate(v.x), reference::approximate(v.y)));
  }
  return points;
}

// The largest distance of a visible point of the triangle from the line through two points.
double width_beside(const std::vector<ScreenPoint>& edge, const reference::Truth& truth,
                    const SceneTriangle& triangle) {
  const double x = edge[1][0] - edge[0][0], y = edge[1][1] - edge[0][1];
  const double length = std::hypot(x, y);
  double width = 0;
  for (const ScreenPoint& p : visible_part(truth, reference::input_triangle(triangle).vertices)) {
    const double dx = p[0] - edge[0][0], dy = p[1] - edge[0][1];
    const double distance = length > 0 ? std::abs(dx * y - dy * x) / length : std::hypot(dx, dy);
    width = std::max(width, distance);
  }
  return width;
}

}  // namespace

std::vector<SharedEdge> shared_edges(const Mesh& mesh) {
  std::vector<SharedEdge> edges;
  for_each_edge(half_edges(mesh), [&](std::span<const HalfEdge> sides) {
    const HalfEdge& first = sides.front();
    for (const HalfEdge& side : sides) {
      if (side.triangle == first.triangle) continue;
      edges.push_back({{first.triangle, side.triangle}, {first.opposite, side.opposite}});
    }
  });
  return edges;
}

std::vector<CutEdge> cut_edges(const Scene& scene, const View& view,
                               const std::vector<SharedEdge>& edges, std::size_t limit) {
  const auto truth = reference::Truth::of_frustum(frustum_cast<double>(view.frustum));
  std::vector<SceneTriangle> triangles(scene.mesh.triangles.size());
  view_triangles(scene, view, 0, triangles);
  std::vector<Corners> corners;
  for (const SceneTriangle& t : triangles) corners.push_back(corners_of(truth, t));
  std::vector<SharedEdge> candidates;
  std::ranges::copy_if(edges, std::back_inserter(candidates), [&](const SharedEdge& e) {
    return may_be_touched(corners[e.triangles[0]], corners[e.triangles[1]], e.opposite[0]);
  });
  std::vector<CutEdge> result;
  for (const SharedEdge& e : at_most(limit, candidates)) {
    const SceneTriangle &first = triangles[e.triangles[0]], &second = triangles[e.triangles[1]];
    const auto [i, j] = ends_of(e.opposite[0]);
    const std::array ends = {reference::input_vertex(first[i]), reference::input_vertex(first[j])};
    const std::vector<ScreenPoint> visible = visible_part(truth, ends);
    if (visible.size() != 2) continue;
    const Corners &a = corners[e.triangles[0]], &b = corners[e.triangles[1]];
    result.push_back({e,
                      a.outside[i] | a.outside[j],
                      a.cut_by() != b.cut_by(),
                      {width_beside(visible, truth, first), width_beside(visible, truth, second)}});
  }
  return result;
}

}  // namespace clipscope::experiments::watertight

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/watertight/shared_edges.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "experiments/judge/match.hpp"
#include "reference/exact_clip.hpp"

namespace clipscope::experiments::watertight {
namespace {

// For each position the index of the first one that equals it.
std::vector<std::uint32_t> welded(const Mesh& mesh) {
  std::map<std::array<float, 3>, std::uint32_t> known;
  std::vector<std::uint32_t> first;
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
    first.push_back(known.try_emplace(mesh.positions[i], i).first->second);
  }
  return first;
}

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

// The ends of the edge: the two corners that are not opposite to it.
std::pair<std::size_t, std::size_t> ends_of(int opposite) {
  const auto k = static_cast<std::size_t>(opposite);
  return {(k + 1) % 3, (k + 2) % 3};
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
  const std::vector<std::uint32_t> vertex = welded(mesh);
  // The triangles beside an edge, by its ends, the lower first; each with its opposite corner.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::pair<std::uint32_t, int>>>
      sides;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int opposite = 0; opposite < 3; ++opposite) {
      const auto [i, j] = ends_of(opposite);
      const std::uint32_t a = vertex[mesh.triangles[t][i]], b = vertex[mesh.triangles[t][j]];
      if (a != b) sides[std::minmax(a, b)].emplace_back(t, opposite);
    }
  }
  std::vector<SharedEdge> edges;
  for (const auto& [ends, all] : sides) {
    const auto& [first, corner] = all.front();
    for (const auto& [other, other_corner] : all) {
      if (other != first) edges.push_back({{first, other}, {corner, other_corner}});
    }
  }
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
  for (const SharedEdge& e : evenly_spaced(candidates, limit)) {
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/watertight/edge_gap.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>

#include "experiments/judge/cycle.hpp"
#include "experiments/judge/outcome.hpp"

namespace clipscope::experiments::watertight {
namespace {

constexpr int kCarried = 0, kFirstMark = 1;  // attributes
constexpr std::size_t kCompared = 5;         // x, y, z, 1/w and the carried attribute

bool is_on_edge(const VertexView& v, const EdgeSide& side) {
  return v.attribute(kFirstMark + side.opposite).value == 0;
}

bool is_gone(const EdgeSide& side) {
  return std::ranges::all_of(side.polygon,
                             [&](const VertexView& v) { return is_on_edge(v, side); });
}

bool holds(const std::vector<VertexView>& vertices, const VertexView& v) {
  return std::ranges::any_of(vertices, [&](const VertexView& u) {
    return same_vertex(u, v, kCompared, Likeness::by_value);
  });
}

// The distinct vertices of the side's polygon that lie on the edge.
std::vector<VertexView> on_edge(const EdgeSide& side) {
  std::vector<VertexView> vertices;
  for (const VertexView& v : side.polygon) {
    if (is_on_edge(v, side) && !holds(vertices, v)) vertices.push_back(v);
  }
  return vertices;
}

// The way from one vertex to another, px.
glm::dvec2 offset(const Format& format, const VertexView& from, const VertexView& to) {
  return {difference(format, to[0], from[0]).value * kScreenWidth / 2,
          difference(format, to[1], from[1]).value * kScreenHeight / 2};
}

// The way to p from the point of segment a-b that is nearest to it.
glm::dvec2 offset_from_segment(const Format& format, const VertexView& a, const VertexView& b,
                               const VertexView& p) {
  const glm::dvec2 ap = offset(format, a, p), ab = offset(format, a, b);
  const double square = glm::dot(ab, ab), along = glm::dot(ap, ab);
  if (!(along > 0)) return ap;
  if (along >= square) return offset(format, b, p);
  return ap - along / square * ab;
}

// How far p is from the polygon's outline.
double distance_to_outline(const PolygonView& polygon, const VertexView& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const VertexView a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const glm::dvec2 away = offset_from_segment(polygon.format(), a, b, p);
    nearest = std::min(nearest, std::hypot(away.x, away.y));
  }
  return nearest;
}

// Adds the vertices of one side that have no partner in the piece of the other.
void add_alone(const std::vector<VertexView>& piece, const std::vector<VertexView>& other_piece,
               const EdgeSide& other, EdgeGap& gap) {
  for (const VertexView& v : piece) {
    if (holds(other_piece, v)) continue;
    ++gap.t_junctions;
    const double distance = std::min(distance_to_outline(other.polygon, v), other.width_px);
    if (distance <= gap.crack_px) continue;
    gap.crack_px = distance;
    gap.at = {v[0].value, v[1].value};
  }
}

}  // namespace

SceneTriangle marked(const SceneTriangle& triangle, const Contestant& contestant) {
  const bool by_weight =
      contestant.format->is_exact() || contestant.clipper.starts_with("barycentric/");
  const float mark = by_weight ? 1 : std::numeric_limits<float>::quiet_NaN();
  SceneTriangle result = triangle;
  for (int i = 0; i < 3; ++i) {
    auto& [position, attributes] = result[static_cast<std::size_t>(i)];
    attributes.values = {position[0], 0, 0, 0};
    attributes[kFirstMark + i] = mark;
  }
  return result;
}

EdgeGap edge_gap(const EdgeSide& first, const EdgeSide& second) {
  const bool first_gone = is_gone(first), second_gone = is_gone(second);
  if (first_gone || second_gone) {
    const bool absent = (first_gone && second_gone) || on_edge(first_gone ? second : first).empty();
    if (absent) return {.identical = true, .absent = true};
    return {.lost = true, .lost_px = first_gone ? first.width_px : second.width_px};
  }
  const std::vector<VertexView> a = on_edge(first), b = on_edge(second);
  EdgeGap gap;
  add_alone(a, b, second, gap);
  add_alone(b, a, first, gap);
  gap.identical = gap.t_junctions == 0;
  return gap;
}

}  // namespace clipscope::experiments::watertight

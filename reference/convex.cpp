// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/convex.hpp"

#include <cassert>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace clipscope::reference {
namespace {

// Position and attributes as one vector.
using Point = std::vector<Dyadic>;

// a - b.
Point difference(const InputVertex& a, const InputVertex& b, int attribute_count) {
  Point r;
  for (std::size_t i = 0; i < a.position.size(); ++i) {
    r.push_back(Dyadic(a.position[i]) - Dyadic(b.position[i]));
  }
  for (int k = 0; k < attribute_count; ++k) {
    r.push_back(Dyadic(a.attributes[k]) - Dyadic(b.attributes[k]));
  }
  return r;
}

Dyadic minor(const Point& a, const Point& b, std::size_t i, std::size_t j) {
  return a[i] * b[j] - a[j] * b[i];
}

// Two of the polygon's directions, and two coordinates of position in which they span an area.
struct Chart {
  Point u, v;
  std::size_t i, j;
};

std::optional<Chart> area_chart(const Point& u, const Point& v, std::size_t dimension) {
  for (std::size_t i = 0; i < dimension; ++i) {
    for (std::size_t j = i + 1; j < dimension; ++j) {
      if (!minor(u, v, i, j).is_zero()) return Chart{u, v, i, j};
    }
  }
  return std::nullopt;
}

// Points are relative to the first one, which is 0.
std::optional<Chart> find_chart(const std::vector<Point>& points, std::size_t dimension) {
  for (std::size_t p = 1; p < points.size(); ++p) {
    for (std::size_t q = p + 1; q < points.size(); ++q) {
      if (const auto chart = area_chart(points[p], points[q], dimension)) return chart;
    }
  }
  return std::nullopt;
}

// Whether the minor of u, v and the point is 0 in the coordinates i, j and every third one.
bool is_in_plane(const Chart& chart, const Point& point) {
  const Dyadic uv = minor(chart.u, chart.v, chart.i, chart.j);
  const Dyadic vp = minor(chart.v, point, chart.i, chart.j);
  const Dyadic pu = minor(point, chart.u, chart.i, chart.j);
  for (std::size_t c = 0; c < point.size(); ++c) {
    const Dyadic sum = uv * point[c] + vp * chart.u[c] + pu * chart.v[c];
    if (!sum.is_zero()) return false;
  }
  return true;
}

// The side of the directed line a-b that c lies on, in the coordinates of the chart: 1 is left.
int side(const Chart& chart, const Point& a, const Point& b, const Point& c) {
  const auto [i, j] = std::pair(chart.i, chart.j);
  const Dyadic area = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
  return static_cast<int>(area.sign());
}

bool is_convex(const Chart& chart, const std::vector<Point>& points) {
  const std::size_t n = points.size();
  std::set<int> sides;
  for (std::size_t e = 0; e < n; ++e) {
    for (std::size_t p = 0; p < n; ++p) {
      sides.insert(side(chart, points[e], points[(e + 1) % n], points[p]));
    }
  }
  return !sides.contains(-1) || !sides.contains(1);
}

bool are_distinct(const Chart& chart, const std::vector<Point>& points) {
  for (std::size_t p = 0; p < points.size(); ++p) {
    for (std::size_t q = p + 1; q < points.size(); ++q) {
      if (points[p][chart.i] == points[q][chart.i] && points[p][chart.j] == points[q][chart.j]) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

bool is_planar_convex(std::span<const InputVertex> vertices, int attribute_count) {
  assert(is_finite(vertices, attribute_count));
  if (vertices.size() < 3) return false;
  std::vector<Point> points;
  for (const InputVertex& vertex : vertices) {
    points.push_back(difference(vertex, vertices[0], attribute_count));
  }
  const std::optional<Chart> chart = find_chart(points, vertices[0].position.size());
  if (!chart) return false;
  for (const Point& point : points) {
    if (!is_in_plane(*chart, point)) return false;
  }
  return are_distinct(*chart, points) && is_convex(*chart, points);
}

}  // namespace clipscope::reference

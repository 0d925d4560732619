// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/distance.hpp"
#include "experiments/judge/match.hpp"

namespace clipscope::experiments {
namespace {

using Polygon = std::vector<Lifted<double>>;

// Fewer than three vertices are a degenerate triangle.
Polygon polygon_of(std::span<const ScreenPoint> points) {
  Polygon polygon;
  for (const ScreenPoint& p : points) polygon.push_back({p[0], p[1]});
  while (polygon.size() < 3) polygon.push_back(polygon.back());
  return polygon;
}

double farthest_from(const Polygon& polygon, const Polygon& other) {
  double largest = 0;
  for (const Lifted<double>& p : polygon) {
    largest = std::max(largest, squared_distance_to_polygon(p, other));
  }
  return std::sqrt(largest);
}

}  // namespace

double diameter(std::span<const ScreenPoint> points) {
  double largest = 0;
  for (const ScreenPoint& p : points) {
    for (const ScreenPoint& q : points) {
      largest = std::max(largest, std::hypot(p[0] - q[0], p[1] - q[1]));
    }
  }
  return largest;
}

double screen_distance(std::span<const ScreenPoint> a, std::span<const ScreenPoint> b) {
  if (a.empty() || b.empty()) return diameter(a.empty() ? b : a);
  const Polygon first = polygon_of(a), second = polygon_of(b);
  return std::max(farthest_from(first, second), farthest_from(second, first));
}

}  // namespace clipscope::experiments

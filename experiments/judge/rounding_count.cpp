// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/rounding_count.hpp"

#include <algorithm>

#include "experiments/judge/equal_numbers.hpp"
#include "experiments/judge/match.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kPosition = 4;  // x, y, z, 1/w

using CountedNumbers = std::vector<double>;

template <class Polygon>
std::vector<CountedNumbers> numbers_of_vertices(const Polygon& polygon) {
  std::vector<CountedNumbers> vertices;
  for (const VertexView& v : polygon) {
    CountedNumbers& numbers = vertices.emplace_back();
    for (std::size_t i = 0; i < v.size(); ++i) numbers.push_back(v[i].value);
  }
  return vertices;
}

// All numbers of so many vertices, wrong.
RoundingCount all_wrong(std::size_t vertices, std::size_t numbers) {
  const auto coordinates = static_cast<std::int64_t>(vertices * kPosition);
  const auto attributes = static_cast<std::int64_t>(vertices * (numbers - kPosition));
  return {coordinates, coordinates, attributes, attributes};
}

// Vertex i of the one belongs to vertex (i + rotation) % n of the other. Pre-condition: as many.
RoundingCount counted_at(std::size_t rotation, const std::vector<CountedNumbers>& nearest,
                         const std::vector<CountedNumbers>& found) {
  RoundingCount count = all_wrong(nearest.size(), found.front().size());
  for (std::size_t v = 0; v < nearest.size(); ++v) {
    const CountedNumbers& vertex = found[(v + rotation) % found.size()];
    for (std::size_t i = 0; i < vertex.size(); ++i) {
      if (vertex[i] != nearest[v][i]) continue;
      --(i < kPosition ? count.misrounded : count.misrounded_attributes);
    }
  }
  return count;
}

}  // namespace

const std::vector<NearestPolygon::Numbers>& NearestPolygon::nearest_in(const Format& format) {
  std::vector<Numbers>& vertices = nearest_[format.is_float() ? 0 : 1];
  if (!vertices.empty()) return vertices;
  for (std::size_t v = 0; v < truth_.exact.vertices.size(); ++v) {
    Numbers& numbers = vertices.emplace_back();
    for (std::size_t i = 0; i < truth_.approximation[v].size(); ++i) {
      const reference::Fraction& exact = coordinate(truth_.exact.vertices[v], static_cast<int>(i));
      numbers.push_back(format.is_float() ? double{reference::round_to<float>(exact)}
                                          : reference::round_to<double>(exact));
    }
  }
  return vertices;
}

RoundingCount NearestPolygon::count(const PolygonView& polygon) {
  if (!truth_.is_visible()) {
    const std::vector<VertexView> vertices = distinct_vertices(polygon);
    if (vertices.size() < truth_.needed) return {};
    return all_wrong(vertices.size(), vertices.front().size());
  }
  const std::vector<Numbers>& nearest = nearest_in(polygon.format());
  // A guest may answer fewer attributes than there are.
  const std::size_t numbers = polygon.empty() ? nearest.front().size() : polygon[0].size();
  RoundingCount count = all_wrong(nearest.size(), numbers);
  constexpr Likeness kValue = Likeness::by_value;
  if (same_cycle(without_repeats(numbers_of_vertices(polygon), kValue),
                 without_repeats(nearest, kValue), kValue)) {
    count.misrounded = count.misrounded_attributes = 0;
    return count;
  }
  const auto found = numbers_of_vertices(distinct_vertices(polygon));
  if (found.size() != nearest.size()) return count;
  return counted_at(most_equal_rotation(nearest, found), nearest, found);
}

}  // namespace clipscope::experiments

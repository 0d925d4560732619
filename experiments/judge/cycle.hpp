// SPDX-License-Identifier: GPL-3.0-or-later
//
// Is this the same polygon? The one answer of the project.
//
// Two polygons are the same if they have the same cycle of vertices, in the same winding, whichever
// vertex is first. The policy:
//
//   zeros    by value 0 and -0 are the same; by bits they differ
//   NaN      a NaN is the same as a NaN; by bits only with the same sign and payload
//   repeats  count as vertices; `without_repeats` takes those out that equal the one before them,
//            the last before the first
//
// A vertex is anything with size() and [] that gives its numbers (VertexView, a span, an array), a
// polygon anything with size() and [] that gives its vertices.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

#include "experiments/contestants/answers.hpp"

namespace clipscope::experiments {

enum class Likeness { by_value, by_bits };

template <std::floating_point F>
bool same_number(F a, F b, Likeness likeness) {
  using Bits = std::conditional_t<sizeof(F) == 4, std::uint32_t, std::uint64_t>;
  if (likeness == Likeness::by_bits) return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
  return a == b || (std::isnan(a) && std::isnan(b));
}

inline bool same_number(const Number& a, const Number& b, Likeness likeness) {
  if (a.exact && b.exact) return a == b;
  return same_number(a.value, b.value, likeness) && same_number(a.rest, b.rest, likeness);
}

// Whether the first `count` numbers are the same.
template <class V>
bool same_vertex(const V& a, const V& b, std::size_t count, Likeness likeness) {
  for (std::size_t i = 0; i < count; ++i) {
    if (!same_number(a[i], b[i], likeness)) return false;
  }
  return true;
}
template <class V>
bool same_vertex(const V& a, const V& b, Likeness likeness) {
  return a.size() == b.size() && same_vertex(a, b, a.size(), likeness);
}

// The shift for which vertex i of a is the same as vertex (i + shift) % n of b; nothing if there is
// none. same(u, v): whether two vertices are.
template <class A, class B, class Same>
std::optional<std::size_t> find_shift(const A& a, const B& b, const Same& same) {
  const std::size_t n = a.size();
  if (n != b.size()) return std::nullopt;
  for (std::size_t shift = 0; shift < std::max<std::size_t>(1, n); ++shift) {
    std::size_t equal = 0;
    while (equal < n && same(a[equal], b[(equal + shift) % n])) ++equal;
    if (equal == n) return shift;
  }
  return std::nullopt;
}
template <class A, class B, class Same>
bool same_cycle(const A& a, const B& b, const Same& same) {
  return find_shift(a, b, same).has_value();
}
template <class A, class B>
bool same_cycle(const A& a, const B& b, Likeness likeness) {
  return same_cycle(a, b,
                    [&](const auto& u, const auto& v) { return same_vertex(u, v, likeness); });
}

// The vertices but repeats, in order.
template <class Polygon, class Same>
auto without_repeats(const Polygon& polygon, const Same& same) {
  std::vector<std::remove_cvref_t<decltype(polygon[0])>> vertices;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (vertices.empty() || !same(polygon[i], vertices.back())) vertices.push_back(polygon[i]);
  }
  while (vertices.size() > 1 && same(vertices.front(), vertices.back())) vertices.pop_back();
  return vertices;
}
template <class Polygon>
auto without_repeats(const Polygon& polygon, Likeness likeness) {
  return without_repeats(polygon,
                         [&](const auto& u, const auto& v) { return same_vertex(u, v, likeness); });
}

// The vertex's numbers, each as a float.
inline std::vector<float> floats_of(const VertexView& v) {
  std::vector<float> floats;
  for (std::size_t i = 0; i < v.size(); ++i) floats.push_back(static_cast<float>(v[i].value));
  return floats;
}

}  // namespace clipscope::experiments

// SPDX-License-Identifier: MIT
//
// Binary searches along the boundary of a convex window.
//
// Along the boundary the side that a line gives a vertex rises to one summit and falls to one
// valley.
// Source: Chazelle and Dobkin, "Intersection of Convex Objects in Two and Three Dimensions", JACM
// 34(1), 1987.
// Guarantees: ceil(log2 N) steps at most, in rounded arithmetic, too.
#pragma once

#include "spaces/window/convex_window.hpp"

namespace clipscope::window {

// The edge by which the boundary passes from `from` to the other side, between the vertices from
// and to, counter-clockwise. Pre-condition: from < to < from + size(), on different sides.
template <Scalar T>
constexpr std::size_t passing_edge(const ConvexWindow<T>& window, const DirectedLine<T>& line,
                                   std::size_t from, std::size_t to, bool from_left) {
  while (to - from > 1) {
    const std::size_t middle = from + (to - from) / 2;
    const bool is_left = T(0) < line.side(window.vertex(middle));
    (is_left == from_left ? from : to) = middle;
  }
  return window.wrapped(from);
}

// Both edges of the line that separates the vertices left and right.
template <Scalar T>
constexpr EdgePair passing_edges(const ConvexWindow<T>& window, const DirectedLine<T>& line,
                                 std::size_t left, std::size_t right) {
  const std::size_t n = window.size();
  return {passing_edge(window, line, left, right < left ? right + n : right, true),
          passing_edge(window, line, right, left < right ? left + n : left, false)};
}

}  // namespace clipscope::window

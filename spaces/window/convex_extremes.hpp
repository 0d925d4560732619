// SPDX-License-Identifier: MIT
//
// Segments in a convex polygon by way of its extreme vertices: O(log N).
//
// Edges are sorted by direction, since the polygon is convex. Two binary searches in that order,
// for the segment's direction and for the opposite one, give the vertices farthest to the right and
// to the left of the line, by directions alone. If the line passes between them, two more searches
// along the boundary give the edges that it crosses.
// Source: Chazelle and Dobkin, "Intersection of Convex Objects in Two and Three Dimensions", JACM
// 34(1), 1987. Rappoport, "An Efficient Algorithm for Line and Polygon Clipping", The
// Visual Computer 7(1), 1991, brings such searches to clipping; its own text was not at hand.
// What the closed window adds: a line along an edge is found by window::edges_against.
// Guarantees: two divisions at most, 4 ceil(log2 N) steps.
// Does not guarantee: the same bits for a segment and its reverse.
#pragma once

#include "spaces/window/convex_search.hpp"

namespace clipscope {

struct ConvexExtremes {
  static constexpr std::string_view name = "convex/extreme_vertices";
  static constexpr std::string_view summary =
      "searches the extreme vertices by edge directions, then the crossed edges between them";
  static constexpr std::string_view source =
      "Chazelle and Dobkin, Intersection of Convex Objects in Two and Three Dimensions, 1987";

  template <Scalar T>
  constexpr std::optional<Segment2<T>> operator()(const ConvexWindow<T>& window,
                                                  const Segment2<T>& segment) const {
    const DirectedLine<T> line(segment);
    const Vec2<T>& along = line.direction();
    Vec2<T> back;
    for (int i = 0; i < 2; ++i) back[i] = -along[i];
    const std::size_t right = vertex_after(window, along), left = vertex_after(window, back);
    const T left_side = line.side(window.vertex(left));
    if (left_side == T(0)) {
      return window::cut_by_pair(window, segment, window::edges_against(window, line, left));
    }
    if (!(T(0) < left_side) || T(0) < line.side(window.vertex(right))) return std::nullopt;
    return window::cut_by_pair<T>(window, segment,
                                  window::passing_edges(window, line, left, right));
  }

 private:
  // Whether a direction points up, or to the right along the x-axis: the first half of the turn
  // that the edges make from the lowest vertex on.
  template <Scalar T>
  static constexpr bool is_in_first_half(const Vec2<T>& v) {
    return T(0) < v[1] || (v[1] == T(0) && T(0) < v[0]);
  }

  // The first vertex, from the lowest on, whose edge does not come before the direction in that
  // turn: the one farthest to the right of a line in that direction.
  template <Scalar T>
  static constexpr std::size_t vertex_after(const ConvexWindow<T>& window,
                                            const Vec2<T>& direction) {
    const bool first_half = is_in_first_half(direction);
    std::size_t from = 0, to = window.size();
    while (from < to) {
      const std::size_t middle = from + (to - from) / 2;
      const Vec2<T>& n = window.normal(middle);
      const Vec2<T> edge(n[1], T(-n[0]));
      const bool edge_in_first_half = is_in_first_half(edge);
      bool before = edge_in_first_half;
      if (edge_in_first_half == first_half) {
        const T turn = n[0] * direction[0] + n[1] * direction[1];
        before = T(0) < turn;
      }
      if (before) {
        from = middle + 1;
      } else {
        to = middle;
      }
    }
    return window.wrapped(from);
  }
};

}  // namespace clipscope

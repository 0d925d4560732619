// SPDX-License-Identifier: MIT
//
// Skala's O(lg N) method for segments in a convex polygon.
//
// The boundary is halved until two vertices on different sides of the segment's line are found; the
// two chains between them are halved on, each to the one edge that passes the line. While all
// vertices seen are on one side, the half is kept in which the boundary comes nearer to the line:
// from the direction of the boundary at both vertices and from which of them is nearer.
// Source: Skala, "O(lg N) Line Clipping Algorithm in E2", Computers & Graphics 18(4), 1994, of
// which the abstract and the introduction were at hand. Which half to keep: the usual search for an
// extreme vertex (O'Rourke, "Computational Geometry in C", 1998).
// What the closed window adds: a line along an edge is found by window::edges_against.
// Guarantees: two divisions at most, 2 ceil(log2 N) steps.
// Does not guarantee: the same bits for a segment and its reverse.
#pragma once

#include "spaces/window/convex_search.hpp"

namespace clipscope {

struct ConvexSkalaLogarithmic {
  static constexpr std::string_view name = "convex/skala_logarithmic";
  static constexpr std::string_view summary =
      "halves the boundary until vertices on both sides are found, then both chains";
  static constexpr std::string_view source = "Skala, O(lg N) Line Clipping Algorithm in E2, 1994";

  template <Scalar T>
  constexpr std::optional<Segment2<T>> operator()(const ConvexWindow<T>& window,
                                                  const Segment2<T>& segment) const {
    const DirectedLine<T> line(segment);
    const T first = line.side(window.vertex(0));
    const Search<T> search{window, line, T(0) < first};
    return window::cut_by_pair(window, segment, search.pair(first));
  }

 private:
  template <Scalar T>
  struct Found {
    std::size_t vertex;
    T side;
  };

  // From vertex 0 to the other side of the line, or to where the boundary is nearest to it.
  template <Scalar T>
  struct Search {
    const ConvexWindow<T>& window;
    const DirectedLine<T>& line;
    bool from_left;

    // first: the side of vertex 0.
    constexpr std::optional<window::EdgePair> pair(const T& first) const {
      Found<T> a{0, first};
      std::size_t end = window.size();
      bool nears = nears_at(0);
      while (end - a.vertex > 1) {
        const std::size_t middle = a.vertex + (end - a.vertex) / 2;
        const Found<T> c{middle, line.side(window.vertex(middle))};
        if ((T(0) < c.side) != from_left) return pair_between(a.vertex, middle, end);
        const bool nears_on = nears_at(middle);
        if (nears ? !nears_on || is_nearer(a.side, c.side)
                  : !nears_on && is_nearer(c.side, a.side)) {
          end = middle;
        } else {
          a = c;
          nears = nears_on;
        }
      }
      if (from_left) return std::nullopt;
      const Found<T> last{window.wrapped(end), line.side(window.vertex(end))};
      const Found<T>& nearest = is_nearer(last.side, a.side) ? last : a;
      if (nearest.side < T(0)) return std::nullopt;
      return window::edges_against(window, line, nearest.vertex);
    }

    // The vertex in the middle is on the other side.
    constexpr window::EdgePair pair_between(std::size_t from, std::size_t middle,
                                            std::size_t end) const {
      const std::size_t there = window::passing_edge(window, line, from, middle, from_left);
      const std::size_t back = window::passing_edge(window, line, middle, end, !from_left);
      return from_left ? window::EdgePair{there, back} : window::EdgePair{back, there};
    }

    // Whether the edge that begins at a vertex leads towards the other side.
    constexpr bool nears_at(std::size_t vertex) const {
      const Vec2<T>& n = window.normal(vertex);
      const T along = n[0] * line.direction()[0] + n[1] * line.direction()[1];
      return from_left ? T(0) < along : along < T(0);
    }

    constexpr bool is_nearer(const T& a, const T& b) const { return from_left ? a < b : b < a; }
  };
};

}  // namespace clipscope

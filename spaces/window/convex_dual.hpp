// SPDX-License-Identifier: MIT
//
// Segments in a convex polygon in constant expected time, after a preparation: by a subdivision of
// the dual plane.
//
// The segment's line falls into a cell of the dual plane, and only the few edges listed there are
// asked whether the line separates their ends.
// Source: Skala, "Line Clipping in E2 with O(1) Processing Complexity", Computers & Graphics 20(4),
// 1996, from which the idea is taken: a preparation of the window, lines as points of the dual
// plane, lists of active edges. The text was not at hand; the cells and lists are this project's
// (dual_subdivision.hpp).
// What the closed window adds: a line along an edge is found by window::edges_against.
// Guarantees: three divisions at most. Exists in scalars that a cell can be told of.
// Does not guarantee: what dual_subdivision.hpp does not; the same bits for a segment and its
// reverse.
#pragma once

#include "spaces/window/dual_subdivision.hpp"

namespace clipscope {

struct ConvexDual {
  static constexpr std::string_view name = "convex/dual_subdivision";
  static constexpr std::string_view summary =
      "asks the few edges listed in the line's cell of the dual plane, which is prepared";
  static constexpr std::string_view source =
      "after Skala, Line Clipping in E2 with O(1) Processing Complexity, 1996";

  // Pre-condition: the window has its subdivision.
  template <Scalar T>
  requires HasDualSubdivision<T>
  constexpr std::optional<Segment2<T>> operator()(const ConvexWindow<T>& window,
                                                  const Segment2<T>& segment) const {
    return window::cut_by_pair(window, segment,
                               crossed(window, window.dual()->edges(segment), segment));
  }

 private:
  template <Scalar T>
  static constexpr std::optional<window::EdgePair> crossed(const ConvexWindow<T>& window,
                                                           std::span<const std::uint32_t> edges,
                                                           const Segment2<T>& segment) {
    const DirectedLine<T> line(segment);
    std::optional<std::size_t> in, out, on, asked;  // asked: the vertex of `side`
    T side(0);
    for (const std::size_t edge : edges) {
      if (asked != edge) side = line.side(window.vertex(edge));
      const bool was_left = T(0) < side;
      if (side == T(0)) on = edge;
      asked = edge + 1;
      side = line.side(window.vertex(edge + 1));
      const bool is_left = T(0) < side;
      if (was_left != is_left) (was_left ? in : out) = edge;
      if (side == T(0)) on = window.wrapped(edge + 1);
      if (in && out) return window::EdgePair{*in, *out};
    }
    if (on && !in && !out) return window::edges_against(window, line, *on);
    return std::nullopt;
  }
};

}  // namespace clipscope

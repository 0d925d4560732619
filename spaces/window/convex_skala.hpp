// SPDX-License-Identifier: MIT
//
// Skala's linear method for segments in a convex polygon: two divisions, whatever N.
//
// The boundary is walked once. An edge whose ends are on different sides of the segment's line is
// one of the two that the line crosses; when both are found the walk ends, and only for these two a
// parameter is computed.
// Source: Skala, "An Efficient Algorithm for Line Clipping by Convex Polygon", Computers & Graphics
// 17(4), 1993, as described in the documentation of the library numba_celltree.
// What the closed window adds: vertices on the line count as right of it, and a line along an edge
// is found by window::edges_against; as published it is a case of its own.
// Guarantees: two divisions at most.
// Does not guarantee: the same bits for a segment and its reverse: sides are measured from the
// first end.
#pragma once

#include "spaces/window/convex_window.hpp"

namespace clipscope {

struct ConvexSkala {
  static constexpr std::string_view name = "convex/skala";
  static constexpr std::string_view summary =
      "walks along the boundary to the two edges that the line separates the ends of";
  static constexpr std::string_view source =
      "Skala, An Efficient Algorithm for Line Clipping by Convex Polygon, 1993";

  template <Scalar T>
  constexpr std::optional<Segment2<T>> operator()(const ConvexWindow<T>& window,
                                                  const Segment2<T>& segment) const {
    return window::cut_by_pair(window, segment, crossed(window, DirectedLine<T>(segment)));
  }

 private:
  template <Scalar T>
  static constexpr std::optional<window::EdgePair> crossed(const ConvexWindow<T>& window,
                                                           const DirectedLine<T>& line) {
    const T first = line.side(window.vertex(0));
    bool was_left = T(0) < first;
    std::optional<std::size_t> in, out, on;
    if (first == T(0)) on = 0;
    for (std::size_t i = 0; i < window.size() && !(in && out); ++i) {
      const T side = line.side(window.vertex(i + 1));
      const bool is_left = T(0) < side;
      if (was_left != is_left) (was_left ? in : out) = i;
      if (side == T(0)) on = window.wrapped(i + 1);
      was_left = is_left;
    }
    if (in && out) return window::EdgePair{*in, *out};
    if (on) return window::edges_against(window, line, *on);
    return std::nullopt;
  }
};

}  // namespace clipscope

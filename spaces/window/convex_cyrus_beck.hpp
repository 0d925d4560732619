// SPDX-License-Identifier: MIT
//
// Cyrus-Beck for segments in a convex polygon: a parameter for every edge.
//
// Source: Cyrus and Beck, "Generalized Two- and Three-Dimensional Clipping", Computers & Graphics
// 3(1), 1978.
// Guarantees: N divisions unless the segment is parallel to an edge. A segment and its reverse give
// the same bits: see parametric_bounds.hpp.
#pragma once

#include "spaces/window/convex_window.hpp"

namespace clipscope {

struct ConvexCyrusBeck {
  static constexpr std::string_view name = "convex/cyrus_beck";
  static constexpr std::string_view summary = "a parameter for every edge, asked once at the end";
  static constexpr std::string_view source =
      "Cyrus and Beck, Generalized Two- and Three-Dimensional Clipping, 1978";

  template <Scalar T>
  constexpr std::optional<Segment2<T>> operator()(const ConvexWindow<T>& window,
                                                  const Segment2<T>& segment) const {
    ParametricBounds<T, std::size_t> bounds;
    bool visible = true;
    for (std::size_t i = 0; i < window.size(); ++i) {
      const bool left =
          bounds.cut(i, window.distance(i, segment[0]), window.distance(i, segment[1]));
      visible = visible && left;
    }
    if (!visible) return std::nullopt;
    return window::if_segment(bounds.move_ends(window, segment));
  }
};

}  // namespace clipscope

// SPDX-License-Identifier: MIT
//
// Segments in a convex polygon by pruning: each end is cut back by the line of each edge in turn.
//
// Source: Wijeweera, Kodituwakku and Chamikara, "A Novel and Efficient Approach for Line Segment
// Clipping Against a Convex Polygon", Ruhuna Journal of Science 10(2), 2019, by its abstract.
// Guarantees: as pruning.hpp; one division for each edge that cuts the segment as it is by then.
// Does not guarantee: the same bits for polygons that begin with another vertex: what one edge
// shortened the next may shorten again, and errors add up. In rounded arithmetic, a segment along
// an edge: an end that another edge cut may fall outside of it by a rounding, and then both are.
#pragma once

#include "spaces/pruning.hpp"
#include "spaces/window/convex_window.hpp"

namespace clipscope {

struct ConvexPruning {
  static constexpr std::string_view name = "convex/pruning";
  static constexpr std::string_view summary = "cuts the ends back by the line of each edge in turn";
  static constexpr std::string_view source =
      "Wijeweera, Kodituwakku and Chamikara, Line Segment Clipping Against a Convex Polygon, 2019";

  template <Scalar T>
  constexpr std::optional<Segment2<T>> operator()(const ConvexWindow<T>& window,
                                                  const Segment2<T>& segment) const {
    Segment2<T> ends = segment;
    for (std::size_t i = 0; i < window.size(); ++i) {
      if (!prune(window, i, ends)) return std::nullopt;
    }
    return window::if_segment(ends);
  }
};

}  // namespace clipscope

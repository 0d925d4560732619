// SPDX-License-Identifier: MIT
//
// Segments in a convex polygon by pruning: each end is cut back by the line of each edge in turn.
//
// An end outside of an edge moves to where the segment, as it is by then, meets the edge's line.
// Both ends of a segment that is outside of an edge would move to the same point, and that they
// coincide in the end is how the paper knows it.
// Source: Wijeweera, Kodituwakku and Chamikara, "A Novel and Efficient Approach for Line Segment
// Clipping Against a Convex Polygon", Ruhuna Journal of Science 10(2), 2019, by its abstract.
// What is mended: a segment whose ends coincide has no line any more, and one parallel to an edge
// never meets it; so a segment outside of an edge is nothing at once.
// Guarantees: one division for each edge that cuts the segment as it is by then.
// Does not guarantee: the same bits for a segment and its reverse, or for polygons that begin with
// another vertex: what one edge shortened the next may shorten again, and errors add up.
#pragma once

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
      const T d_first = window.distance(i, ends[0]);
      const T d_second = window.distance(i, ends[1]);
      const PlaneCut<T> cut = cut_segment(d_first, d_second);
      if (cut.side == SegmentSide::rejected) return std::nullopt;
      if (cut.side == SegmentSide::cut_first) ends[0] = window.meet(i, ends[1], ends[0], cut.t);
      if (cut.side == SegmentSide::cut_second) ends[1] = window.meet(i, ends[0], ends[1], cut.t);
    }
    return window::if_segment(ends);
  }
};

}  // namespace clipscope

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segments against a convex polygon: what the methods of spaces/window/convex_clippers.hpp cost by
// the number of its edges, and what they get wrong.
//
// The windows are regular polygons of 4, 8, ..., 1024 edges about the origin, in a circle of radius
// 1; the segments go from anywhere to anywhere in the square [-2, 2]^2. Vertices and ends are
// floats, and the truth is that of these floats.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/report/plot.hpp"
#include "experiments/survey/contest_clock.hpp"
#include "experiments/table/row.hpp"
#include "spaces/window/rectangle.hpp"

namespace clipscope::experiments::segments {

inline constexpr std::array<int, 9> kConvexEdges = {4, 8, 16, 32, 64, 128, 256, 512, 1024};

// The radius of the windows: they are 2160 px high.
inline constexpr double kConvexRadiusPx = 1080;

struct ConvexCase {
  std::vector<Vec2<float>> vertices;  // counter-clockwise
  std::vector<Segment2<float>> segments;
};

// Pre-condition: edges is 4 times a power of two. The same bits for the same numbers.
ConvexCase make_convex_case(int edges, std::size_t segments, std::uint64_t seed);

// A method in float on the segments of a window.
struct ConvexRow {
  std::int64_t edges = 0;
  std::string method;
  std::optional<Timing> timing = {};
  double divisions = 0;                                      // per segment
  std::int64_t visible = 0, lost = 0, drawn = 0, moved = 0;  // of the judged segments
  double max_px = 0;

  static constexpr std::string_view kName = "segments_convex";
  static constexpr std::string_view kTitle =
      "Segments against a convex polygon: time by its edges, divisions and what is wrong (float)";
  static constexpr std::array<std::string_view, 3> kNotes = {
      "x CB: how many times faster than convex/cyrus_beck on the same segments in the same round; median and 95 % interval. The edges' normals, two subtractions each, are made before, and so is the subdivision of convex/dual_subdivision, with N/2 (at least 16) cells along each axis: some N^2 steps and as many entries. Not timed (-): an answer is more than a pixel off what is visible, by the backward error.",
      "N: edges. /: divisions per segment, by the counting scalar. Seen: judged segments of which more than a point is in the window, in exact arithmetic; lost: of these not found; drawn: found where nothing is visible; moved: found with an end more than 1/256 px from the exact one.",
      "max: the largest distance of an end from the exact one, where both are there; the window is 2160 px high."};
  static constexpr auto columns() {
    using R = ConvexRow;
    return std::tuple(
        column("edges", "N", &R::edges), column("method", &R::method),
        group(&R::timing,
              Timing::columns("ns_per_segment", "ns/segment", "speedup_to_cyrus_beck", "x CB")),
        column("divisions", "/", &R::divisions), column("visible", "seen", &R::visible),
        column("lost", &R::lost), column("drawn", &R::drawn), column("moved", &R::moved),
        column("max_px", "max [px]", &R::max_px));
  }
};

// One row per method. At most so many of the segments are judged.
std::vector<ConvexRow> measure_convex(const ConvexCase& input, std::size_t judged,
                                      const ContestClock& clock);

// Time per segment by edges, a line for each method. Without series if nothing was timed.
Plot convex_plot(const std::vector<ConvexRow>& rows);

// The fastest method of the smallest and the largest window, behind a blank; empty if nothing was
// timed.
std::string convex_finding(const std::vector<ConvexRow>& rows);

}  // namespace clipscope::experiments::segments

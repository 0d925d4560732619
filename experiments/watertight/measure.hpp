// SPDX-License-Identifier: GPL-3.0-or-later
//
// Clippers on the shared edges of a scene: what the two neighbours keep of each edge, tallied by the
// planes that cut it.
//
// Contestants run in parallel, each on all edges in order, so that the result does not depend on the
// number of threads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "experiments/watertight/edge_gap.hpp"
#include "experiments/watertight/shared_edges.hpp"

namespace clipscope::experiments {

struct GapTally {
  std::int64_t edges = 0, identical = 0, absent = 0, lost = 0, t_junctions = 0;
  double lost_px = 0, crack_px = 0;  // the largest

  void add(const EdgeGap& gap);
  GapTally& operator+=(const GapTally& other);
};

// Which planes cut an edge: one of the six, in the order of Plane; several; or none, where the edge is
// inside and only neighbours are cut.
inline constexpr std::size_t kSeveralPlanes = kPlanes, kNoPlane = kPlanes + 1;
inline constexpr std::array<std::string_view, kPlanes + 2> kEdgeClasses = {
    "left", "right", "bottom", "top", "near", "far", "several", "none"};

// The edge with the widest crack; of equally wide ones the first.
struct WorstGap {
  EdgeGap gap;
  std::size_t view = 0;
  CutEdge edge;
};

struct WatertightTally {
  // By class of the edge; then of neighbours outside of the same planes, and of different ones.
  std::array<std::array<GapTally, 2>, kEdgeClasses.size()> by_class;
  WorstGap worst;

  GapTally total() const;
  GapTally with_different_neighbours() const;
};

struct WatertightOptions {
  std::size_t edges_per_view = 0;        // evenly spaced; 0: all
  std::size_t exact_edges_per_view = 0;  // the same for scalars without rounding, which are slow
};

// One tally per contestant.
std::vector<WatertightTally> measure_watertight(const Scene& scene,
                                                std::span<const AnyContestant> contestants,
                                                const WatertightOptions& options);

// What became of a clipper's promise to be watertight: "kept", "broken", or "-" if it makes none. It speaks
// of neighbours of which both have something left (see bit_promise.hpp); that one of them is lost is
// counted apart.
std::string_view watertight_verdict(const AnyContestant& contestant, const GapTally& tally);

// The triangles of an edge in view space.
std::array<SceneTriangle, 2> neighbours_of(const Scene& scene, const View& view,
                                           const SharedEdge& edge);

// The polygons of the two triangles as a contestant clips them, rounded to double (x, y in NDC), and what
// they keep of their edge.
struct ClippedPair {
  std::array<std::vector<std::array<double, 2>>, 2> polygons;
  EdgeGap gap;
};
ClippedPair clipped_pair(const AnyContestant& contestant, const View& view,
                         const std::array<SceneTriangle, 2>& triangles, const CutEdge& edge);

// The two triangles as two lines of hex floats, and the command that shows both polygons.
std::string input_text(const std::array<SceneTriangle, 2>& triangles);
std::string replay_command(const AnyContestant& contestant, const View& view,
                           const std::array<SceneTriangle, 2>& triangles);

}  // namespace clipscope::experiments

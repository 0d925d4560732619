// SPDX-License-Identifier: GPL-3.0-or-later
//
// Clippers on the shared edges of a scene: what the two neighbours keep of each edge, tallied by
// the planes that cut it.
//
// Contestants run in parallel, each on all edges in order, so that the result does not depend on
// the number of threads.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "experiments/store/piece_record.hpp"
#include "experiments/watertight/edge_gap.hpp"
#include "experiments/watertight/rows.hpp"
#include "experiments/watertight/shared_edges.hpp"

namespace clipscope::experiments::watertight {

struct Options {
  std::size_t edges_per_view = 0;        // evenly spaced; 0: all
  std::size_t exact_edges_per_view = 0;  // the same for scalars without rounding, which are slow
};

struct Measured {
  Row row;
  std::map<std::pair<EdgeClass, Neighbours>, GapTally> by_class;
  WorstRow worst;  // of equally wide cracks the first; crack_px is 0 if there is none
};

// One for each contestant.
std::vector<Measured> measure(const Scene& scene, const Contestants& contestants,
                              const Options& options);

// The polygons of the two triangles that a row of the scene names, rounded to double (x, y in NDC),
// and what they keep of their edge.
struct Crack {
  std::array<std::vector<std::array<double, 2>>, 2> polygons;
  EdgeGap gap;
};
Crack crack_of(const Scene& scene, const WorstRow& row);

// Draws the two clipped neighbours, and the place where they part, magnified: an SVG, a PDF or a
// PNG file, by its extension, which appears complete or not at all. Title: whose crack, and where,
// in one line. Pre-condition: the crack is wider than 0. Errors: UsageError for another extension,
// OutputError.
void write_picture(const std::filesystem::path& path, const Crack& crack, const std::string& title);

// The two triangles as two lines of hex floats, and the command that shows both polygons.
WorstInput worst_input(const Scene& scene, const WorstRow& row);

}  // namespace clipscope::experiments::watertight

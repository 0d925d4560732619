// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tables of the experiment `perspective`.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "experiments/perspective/affine_picture.hpp"
#include "experiments/perspective/cvv_vertices.hpp"
#include "experiments/perspective/edge_search.hpp"
#include "experiments/perspective/scene_ratios.hpp"
#include "experiments/report/table.hpp"

namespace clipscope::experiments {

inline constexpr std::array<int, 3> kTextureSizes = {256, 1024, 4096};  // texels along an edge

struct PerspectiveTables {
  Table ratios, thresholds, scenes, clip, pictures;

  PerspectiveTables();
};

void add_ratio(Table& table, const EdgeSearch& search);

// Each error that can be seen, and the ratio that it takes.
void add_thresholds(Table& table);

// Pre-condition: something is visible.
void add_scene(Table& table, const std::string& scene, const std::vector<PolygonNeed>& needs);

void add_cut(Table& table, double ratio, const AnyContestant& contestant, const CutError& error);

void add_picture(Table& table, const std::string& scene, Pieces pieces,
                 const HeatMapCounts& counts);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Perspective: ratios of w x affine against correct, on edges and triangles, in scenes, in vertices that
// clipping makes, and in pictures.
#include <fmt/format.h>

#include <algorithm>

#include "experiments/experiment.hpp"
#include "experiments/hex_float.hpp"
#include "experiments/measure/batches.hpp"
#include "experiments/perspective/affine_picture.hpp"
#include "experiments/perspective/named_contestants.hpp"
#include "experiments/perspective/summary.hpp"
#include "experiments/perspective/tables.hpp"
#include "experiments/report/progress.hpp"

namespace clipscope::experiments {
namespace {

// Square roots of the ratios: their squares, the ratios and the bounds are exact rationals.
constexpr std::array kRoots = {1.0,        1 + 0x1p-14, 1 + 0x1p-12, 1 + 0x1p-10, 1 + 0x1p-8,
                               1 + 0x1p-6, 1 + 0x1p-4,  1.25,        1.5,         2.0,
                               3.0,        4.0,         6.0,         8.0,         12.0,
                               16.0,       24.0,        32.0,        64.0,        100.0};
constexpr std::array kCutRatios = {1.015625f, 1.25f, 2.0f, 16.0f, 256.0f, 4096.0f};
constexpr std::array<std::string_view, 4> kCutClippers = {"cvv/naive", "cvv/perspective",
                                                          "homogeneous/sutherland_hodgman",
                                                          "barycentric/distance_matrix"};

std::size_t sample_size(const Selection& selection, std::size_t full, std::size_t quick) {
  if (selection.sample != 0) return selection.sample;
  return selection.quick ? quick : full;
}

void measure_ratios(const ExperimentContext& context, PerspectiveTables& tables) {
  const Selection& selection = context.selection();
  const EdgeSearchOptions options{.triangles = selection.quick ? 500 : 10000,
                                  .seed = selection.seed};
  Progress progress("perspective: ratios", kRoots.size());
  for (const double root : kRoots) {
    context.cell("root " + hex_float(root), {&tables.ratios},
                 [&](CellRecord&) { add_ratio(tables.ratios, search_edges(root, options)); });
    progress.advance();
  }
  context.cell("thresholds", {&tables.thresholds},
               [&](CellRecord&) { add_thresholds(tables.thresholds); });
}

void measure_scenes(const ExperimentContext& context, PerspectiveTables& tables) {
  const Selection& selection = context.selection();
  const std::size_t sample = sample_size(selection, 2000, 200);
  for (const std::string& name : scene_names(selection)) {
    context.cell(fmt::format("scene {}", name), {&tables.scenes}, [&](CellRecord&) {
      const Scene scene = load_selected_scene(selection, name);
      Progress progress(fmt::format("perspective in {}", scene.name),
                        sample_of(scene, sample).count * scene.views.size());
      const auto needs = scene_needs(scene, sample, progress);
      if (!needs.empty()) add_scene(tables.scenes, scene.name, needs);
    });
  }
}

void measure_cuts(const ExperimentContext& context, PerspectiveTables& tables) {
  const Selection& selection = context.selection();
  Progress progress("perspective: cut after the divide", kCutRatios.size());
  for (const float ratio : kCutRatios) {
    context.cell(fmt::format("cut {}", ratio), {&tables.clip}, [&](CellRecord& record) {
      const auto triangles =
          cut_triangles(ratio, sample_size(selection, 2000, 200), selection.seed);
      for (const AnyContestant& contestant : named_contestants(selection, kCutClippers)) {
        const CutError error = attribute_error_of_cut(contestant, triangles);
        add_cut(tables.clip, ratio, contestant, error);
        if (error.max > 0) record.worst_inputs.push_back(worst_input(contestant, error));
      }
    });
    progress.advance();
  }
}

void draw_pictures(const ExperimentContext& context, PerspectiveTables& tables) {
  const Selection& selection = context.selection();
  const std::vector<std::string> names =
      selection.scenes.empty() ? std::vector<std::string>{"floor"} : selection.scenes;
  for (const std::string& name : names) {
    for (const Pieces pieces : {Pieces::near_cut, Pieces::clipped, Pieces::split}) {
      context.cell(
          fmt::format("picture {} {}", name, pieces_name(pieces)), {&tables.pictures},
          [&](CellRecord& record) {
            const Scene scene = load_selected_scene(selection, name);
            const auto picture = draw_affine(scene, scene.views.front(), pieces, {640, 360});
            add_picture(tables.pictures, scene.name, pieces, picture.error.counts);
            record.pictures.push_back(write_affine_picture(context.out(), scene, pieces, picture));
          });
    }
  }
}

}  // namespace

void run_perspective(const ExperimentContext& context) {
  PerspectiveTables tables;
  measure_ratios(context, tables);
  measure_scenes(context, tables);
  measure_cuts(context, tables);
  draw_pictures(context, tables);
  for (const Table* table :
       {&tables.ratios, &tables.thresholds, &tables.scenes, &tables.clip, &tables.pictures}) {
    context.emit(*table);
  }
  context.emit(error_over_ratio(tables));
  context.finding(perspective_finding(tables));
}

}  // namespace clipscope::experiments

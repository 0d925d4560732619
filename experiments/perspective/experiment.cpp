// SPDX-License-Identifier: GPL-3.0-or-later
//
// Perspective: ratios of w x affine against correct, on edges and triangles, in scenes, in vertices
// that clipping makes, and in pictures.
#include <fmt/format.h>

#include "experiments/contestants/fewer_attributes.hpp"
#include "experiments/perspective/measure.hpp"
#include "experiments/perspective/rows.hpp"
#include "experiments/report/experiment.hpp"
#include "experiments/store/piece_record.hpp"
#include "experiments/table/hex_float.hpp"

namespace clipscope::experiments::perspective {
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

std::size_t sample_size(const Selection& selection) { return selection.sample_or(200, 2000); }

void measure_ratios(const ExperimentContext& context, Tables& tables) {
  const Selection& selection = context.selection();
  const EdgeSearch search{.triangles = selection.quick ? 500 : 10000, .seed = selection.seed};
  Progress progress("perspective: ratios", kRoots.size());
  for (const double root : kRoots) {
    context.piece("root " + hex_float(root), {&tables.ratios},
                  [&](PieceRecord&) { tables.ratios.add(search_edges(root, search)); });
    progress.advance();
  }
  context.piece("thresholds", {&tables.thresholds}, [&](PieceRecord&) {
    for (const ThresholdRow& row : threshold_rows()) tables.thresholds.add(row);
  });
}

void measure_scenes(const ExperimentContext& context, Tables& tables) {
  const Selection& selection = context.selection();
  const std::size_t sample = sample_size(selection);
  for (const std::string& name : scene_names(selection)) {
    context.piece(fmt::format("scene {}", name), {&tables.scenes}, [&](PieceRecord&) {
      const Scene scene = load_selected_scene(selection, name);
      Progress progress(fmt::format("perspective in {}", scene.name),
                        spacing_of(scene, sample).count * scene.views.size());
      const auto needs = scene_needs(scene, sample, progress);
      if (!needs.empty()) tables.scenes.add(scene_row(scene.name, needs));
    });
  }
}

void measure_cuts(const ExperimentContext& context, Tables& tables) {
  const Selection& selection = context.selection();
  Progress progress("perspective: cut after the divide", kCutRatios.size());
  for (const float ratio : kCutRatios) {
    context.piece(fmt::format("cut {}", ratio), {&tables.cuts}, [&](PieceRecord& record) {
      const auto triangles = cut_triangles(ratio, sample_size(selection), selection.seed);
      for (const Contestant* contestant :
           with_attributes(named_contestants(selection, kCutClippers), kSceneAttributes)) {
        const CutRow row = measure_cut(*contestant, ratio, triangles);
        tables.cuts.add(row);
        if (row.max_error == 0) continue;
        record.worst_inputs.push_back(
            worst_input(*contestant, row.worst, "attribute", row.max_error));
      }
    });
    progress.advance();
  }
}

void draw_pictures(const ExperimentContext& context, Tables& tables) {
  const Selection& selection = context.selection();
  for (const std::string& name : selection.scenes_or({"floor"})) {
    for (const Pieces pieces : {Pieces::near_cut, Pieces::clipped, Pieces::split}) {
      const std::string cell = fmt::format("picture {} {}", name, name_of(pieces));
      context.piece(cell, {&tables.pictures}, [&](PieceRecord& record) {
        const Scene scene = load_selected_scene(selection, name);
        const AffinePicture picture = draw(scene, scene.views.front(), pieces, {640, 360});
        const HeatMapCounts& counts = picture.error.counts;
        tables.pictures.add({scene.name, pieces, counts.max_error, counts.median_error,
                             100 * counts.share_above_one});
        record.pictures.push_back(write_picture(context.out(), scene, pieces, picture));
      });
    }
  }
}

void run(const ExperimentContext& context) {
  Tables tables;
  measure_ratios(context, tables);
  measure_scenes(context, tables);
  measure_cuts(context, tables);
  draw_pictures(context, tables);
  context.emit(tables.ratios, tables.thresholds, tables.scenes, tables.cuts, tables.pictures,
               error_plot(tables));
  context.finding(finding(tables));
}

}  // namespace

extern constinit const Experiment kExperiment{
    "perspective", "When does interpolation need perspective correction?", run};

}  // namespace clipscope::experiments::perspective

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Accuracy: scenes x clippers x scalars against the exact frustum (T_frustum).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "experiments/experiment.hpp"
#include "experiments/measure/accuracy.hpp"
#include "experiments/measure/accuracy_table.hpp"
#include "experiments/measure/batches.hpp"
#include "experiments/measure/machine.hpp"
#include "experiments/measure/worst_input.hpp"
#include "experiments/pictures/draw_scene.hpp"
#include "experiments/report/row_view.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kDefaultSample = 1500;  // triangles per view
constexpr std::size_t kQuickSample = 200;

struct AccuracyTables {
  Table all, worst;
};

AccuracyTables empty_tables() {
  std::vector<Column> columns = accuracy_columns();
  columns.insert(columns.begin(), {"scene", "scene"});
  return {Table("accuracy", "Accuracy against the exact reference", columns),
          Table("accuracy_worst", "The triangle of each scene on which a clipper is farthest off",
                {{"scene", "scene"},
                 {"clipper", "clipper"},
                 {"scalar", "scalar"},
                 {"error_px", "error [px]"},
                 {"view", "view"},
                 {"triangle", "triangle"}})};
}

WorstInput worst_of(const Selection& selection, const Scene& scene, const AnyContestant& contestant,
                    const Worst& worst) {
  const View& view = find_view(scene, worst.view);
  const auto triangles =
      sampled_view_triangles(scene, view, {scene.mesh.triangles.size(), 1}, worst.triangle, 1);
  return worst_input(selection, scene, contestant,
                     {view, triangles.front(), worst.triangle, "position_px", worst.error});
}

void measure_scene(const Scene& scene, const Selection& selection, const AccuracyOptions& options,
                   AccuracyTables& tables, CellRecord& record) {
  const std::vector<AnyContestant> contestants = selected_contestants(selection);
  std::vector<AccuracyTally> tallies(contestants.size());
  Progress progress(fmt::format("accuracy on {}", scene.name), sampled_triangles(scene, options));
  measure_accuracy(scene, contestants, options, tallies, progress);
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    std::vector<Cell> cells = accuracy_cells(contestants[i], tallies[i]);
    cells.insert(cells.begin(), scene.name);
    tables.all.add_row(std::move(cells));
    const Worst& worst = tallies[i].worst_position;
    if (worst.error == 0) continue;
    tables.worst.add_row({scene.name, std::string(clipper_name(contestants[i])),
                          std::string(scalar_name(contestants[i])), worst.error, worst.view,
                          static_cast<std::int64_t>(worst.triangle)});
    record.worst_inputs.push_back(worst_of(selection, scene, contestants[i], worst));
  }
}

// The usual clipper of each space, and the one that computes every vertex from the original three.
constexpr std::array kUsual = {std::pair{"view space", "view/sutherland_hodgman"},
                               std::pair{"clip space", "homogeneous/sutherland_hodgman"},
                               std::pair{"the CVV (near plane first)", "cvv/near_first"},
                               std::pair{"the distance matrix", "barycentric/distance_matrix"}};

// Largest errors of a clipper in float by scene; where no triangle had the right vertices there is none.
std::map<std::string, double> largest_by_scene(const Table& table, const std::string& clipper) {
  std::map<std::string, double> largest;
  for (const RowView& row : rows_of(table)) {
    if (row.text("clipper") != clipper || row.text("scalar") != "float") continue;
    if (const auto px = row.find_number("max_px")) largest[row.text("scene")] = *px;
  }
  return largest;
}

Plot error_plot(const Table& table) {
  Plot plot{.name = "accuracy",
            .title = "Largest error of float clipping on each scene",
            .caption = "Over the triangles whose vertices are the right ones, at 3840 x 2160.",
            .x = {.label = "scene"},
            .y = {.label = "largest error [px]", .logarithmic = true},
            .series = {},
            .categories = {}};
  for (const RowView& row : rows_of(table)) {
    const std::string& scene = row.text("scene");
    if (std::ranges::count(plot.categories, scene) == 0) plot.categories.push_back(scene);
  }
  for (const auto& [space, clipper] : kUsual) {
    const std::map<std::string, double> largest = largest_by_scene(table, clipper);
    if (largest.empty()) continue;
    Series series{.name = space, .x = {}, .y = {}};
    for (const std::string& scene : plot.categories) {
      const auto px = largest.find(scene);
      series.y.push_back(px == largest.end() ? std::nan("") : px->second);
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

std::string finding_of(const Table& table) {
  std::vector<std::string> parts;
  for (const auto& [space, clipper] : kUsual) {
    const std::map<std::string, double> largest = largest_by_scene(table, clipper);
    if (largest.empty()) continue;
    const auto worst = std::ranges::max_element(
        largest, {}, [](const auto& scene_and_px) { return scene_and_px.second; });
    parts.push_back(
        fmt::format("{} {} px on {}", space, format_number(worst->second), worst->first));
  }
  if (parts.empty()) return "None of the usual clippers was asked for in float.";
  return fmt::format(
      "The largest error of float clipping where the vertices are the right ones: {}.",
      fmt::join(parts, ", "));
}

}  // namespace

void run_accuracy(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  const AccuracyOptions options{.triangles_per_view = selection.sample != 0 ? selection.sample
                                                      : selection.quick     ? kQuickSample
                                                                            : kDefaultSample};
  AccuracyTables tables = empty_tables();
  for (const std::string& name : scene_names(selection)) {
    context.cell(name, {&tables.all, &tables.worst}, [&](CellRecord& record) {
      measure_scene(load_selected_scene(selection, name), selection, options, tables, record);
    });
  }
  add_accuracy_notes(tables.all);
  tables.all.add_note(fmt::format("Seed {}; at most {} triangles per view, evenly spaced.",
                                  selection.seed, options.triangles_per_view));
  tables.all.add_note(machine_description());
  tables.worst.add_note(
      fmt::format("Shown digit by digit by: clipscope explain --scene SCENE --view VIEW --triangle "
                  "TRIANGLE --clipper CLIPPER --scalar SCALAR --seed {}{}",
                  selection.seed, selection.quick ? " --quick" : ""));
  context.emit(tables.all);
  context.emit(tables.worst);
  const Plot plot = error_plot(tables.all);
  if (!plot.series.empty()) context.emit(plot);
  context.finding(finding_of(tables.all));
}

}  // namespace clipscope::experiments

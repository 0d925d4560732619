// SPDX-License-Identifier: GPL-3.0-or-later
//
// Accuracy: scenes x clippers x scalars against the exact frustum (T_frustum).
#include <fmt/format.h>

#include <map>

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
}

}  // namespace clipscope::experiments

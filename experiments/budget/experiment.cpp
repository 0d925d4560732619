// SPDX-License-Identifier: GPL-3.0-or-later
//
// Error budget: scenes x clippers x float and double, each error split by the step that it comes from.
#include <fmt/format.h>

#include "experiments/budget/budget.hpp"
#include "experiments/experiment.hpp"
#include "experiments/measure/batches.hpp"
#include "experiments/measure/machine.hpp"
#include "experiments/measure/worst_input.hpp"
#include "experiments/report/row_view.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kTriangles = 5000;  // per scene, over all its views
constexpr std::size_t kQuickTriangles = 500;

// Game-like, all straddling, all across w = 0, hard, and two meshes.
std::vector<std::string> scenes(const Selection& selection) {
  if (!selection.scenes.empty()) return selection.scenes;
  return {"soup", "soup_straddling", "soup_behind", "slivers", "teapot", "terrain"};
}

std::size_t triangles_per_view(const Selection& selection, const Scene& scene) {
  if (selection.sample != 0) return selection.sample;
  const std::size_t all = selection.quick ? kQuickTriangles : kTriangles;
  return std::max<std::size_t>(1, all / scene.views.size());
}

void record_worst(const Selection& selection, const Scene& scene,
                  std::span<const AnyContestant> contestants, std::span<const BudgetTally> tallies,
                  CellRecord& record) {
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    const BudgetTally& tally = tallies[i];
    const double error = tally.parts[static_cast<std::size_t>(BudgetPart::total)].px.max();
    if (error == 0) continue;
    const View& view = scene.views[tally.worst_view];
    SceneTriangle triangle;
    view_triangles(scene, view, tally.worst_triangle, std::span(&triangle, 1));
    record.worst_inputs.push_back(
        worst_input(selection, scene, contestants[i],
                    {view, triangle, tally.worst_triangle, "position_px", error}));
  }
}

}  // namespace

void run_budget(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  const auto contestants = budget_contestants(selection.clipper, selection.scalars);
  Table table = budget_table();
  for (const std::string& name : scenes(selection)) {
    context.cell("scene " + name, {&table}, [&](CellRecord& record) {
      const Scene scene = load_selected_scene(selection, name);
      const std::size_t limit = triangles_per_view(selection, scene);
      Progress progress("budget on " + scene.name,
                        sample_of(scene, limit).count * scene.views.size() * contestants.size());
      const auto tallies = measure_budget(scene, contestants, limit, progress);
      add_budget_rows(scene.name, contestants, tallies, table);
      record_worst(selection, scene, contestants, tallies, record);
    });
  }
  table.add_note(machine_description());
  context.emit(table);
  std::string plotted;
  for (const RowView& row : rows_of(table)) {
    const std::string& scene = row.text("scene");
    if (scene == plotted) continue;
    plotted = scene;
    const Plot plot = budget_plot(table, scene, row.text("scalar"));
    if (!plot.categories.empty()) context.emit(plot);
  }
  context.finding(budget_finding(table));
}

}  // namespace clipscope::experiments

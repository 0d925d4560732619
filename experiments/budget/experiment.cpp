// SPDX-License-Identifier: GPL-3.0-or-later
//
// Error budget: scenes x clippers x float and double, each error split by the step it comes from.
#include <fmt/format.h>

#include "experiments/budget/rows.hpp"
#include "experiments/machine/machine.hpp"
#include "experiments/report/experiment.hpp"

namespace clipscope::experiments::budget {
namespace {

constexpr std::size_t kTriangles = 5000;  // per scene, over all its views
constexpr std::size_t kQuickTriangles = 500;

std::size_t triangles_per_view(const Selection& selection, const Scene& scene) {
  if (selection.sample != 0) return selection.sample;
  const std::size_t all = selection.quick ? kQuickTriangles : kTriangles;
  return std::max<std::size_t>(1, all / scene.views.size());
}

void record_worst(const Selection& selection, const Scene& scene, const Contestant& contestant,
                  const Tally& tally, PieceRecord& record) {
  const double error = tally.part(Part::total).px.max();
  if (error == 0) return;
  const View& view = scene.views[tally.worst_view];
  SceneTriangle triangle;
  view_triangles(scene, view, tally.worst_triangle, std::span(&triangle, 1));
  record.worst_inputs.push_back(worst_input(
      selection, scene, contestant, {view, triangle, tally.worst_triangle, "position_px", error}));
}

void run(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  const Contestants contestants = budget_contestants(selection.clipper, selection.scalars);
  TableOf<Row> table;
  // Game-like, all straddling, all across w = 0, hard, and two meshes.
  for (const std::string& name : selection.scenes_or(
           {"soup", "soup_straddling", "soup_behind", "slivers", "teapot", "terrain"})) {
    context.piece("scene " + name, {&table}, [&](PieceRecord& record) {
      const Scene scene = load_selected_scene(selection, name);
      const std::size_t limit = triangles_per_view(selection, scene);
      Progress progress("budget on " + scene.name,
                        spacing_of(scene, limit).count * scene.views.size() * contestants.size());
      const std::vector<Tally> tallies = measure(scene, contestants, limit, progress);
      for (std::size_t i = 0; i < contestants.size(); ++i) {
        add_rows(scene.name, *contestants[i], tallies[i], table);
        record_worst(selection, scene, *contestants[i], tallies[i], record);
      }
    });
  }
  table.add_note(machine_description());
  context.emit(table);
  const std::vector<Row> rows = table.rows();
  for (const std::string& scene : distinct(rows, &Row::scene)) {
    const Plot shown = plot(rows, scene, find_row(rows, &Row::scene, scene)->scalar);
    if (!shown.categories.empty()) context.emit(shown);
  }
  context.finding(finding(rows));
}

}  // namespace

extern constinit const Experiment kExperiment{
    "budget", "How much of the error comes from the transform, how much from cut and divide?", run};

}  // namespace clipscope::experiments::budget

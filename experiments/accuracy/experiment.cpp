// SPDX-License-Identifier: GPL-3.0-or-later
//
// Accuracy: scenes x clippers x scalars against the exact frustum (T_frustum).
#include <fmt/format.h>

#include "experiments/experiment.hpp"
#include "experiments/measure/accuracy.hpp"
#include "experiments/measure/accuracy_table.hpp"
#include "experiments/measure/machine.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kDefaultSample = 1500;  // triangles per view
constexpr std::size_t kQuickSample = 200;

}  // namespace

void run_accuracy(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  const std::vector<AnyContestant> contestants = selected_contestants(selection);
  const AccuracyOptions options{.triangles_per_view = selection.sample != 0 ? selection.sample
                                                      : selection.quick     ? kQuickSample
                                                                            : kDefaultSample};
  std::vector<Column> columns = accuracy_columns();
  columns.insert(columns.begin(), {"scene", "scene"});
  Table table("accuracy", "Accuracy against the exact reference", columns);
  Table worst("accuracy_worst", "The triangle on which each clipper is farthest off",
              {{"clipper", "clipper"},
               {"scalar", "scalar"},
               {"error_px", "error [px]"},
               {"replay", "replay with: clipscope explain"}});
  std::vector<Worst> farthest(contestants.size());

  for (const std::string& name : scene_names(selection)) {
    const Scene scene = load_selected_scene(selection, name);
    std::vector<AccuracyTally> tallies(contestants.size());
    Progress progress(fmt::format("accuracy on {}", scene.name), sampled_triangles(scene, options));
    measure_accuracy(scene, contestants, options, tallies, progress);
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      std::vector<Cell> cells = accuracy_cells(contestants[i], tallies[i]);
      cells.insert(cells.begin(), scene.name);
      table.add_row(std::move(cells));
      if (tallies[i].worst_position.error > farthest[i].error)
        farthest[i] = tallies[i].worst_position;
    }
  }
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    if (farthest[i].error == 0) continue;
    worst.add_row({std::string(clipper_name(contestants[i])),
                   std::string(scalar_name(contestants[i])), farthest[i].error,
                   fmt::format("--scene {} --view '{}' --triangle {} --seed {}{}",
                               farthest[i].scene, farthest[i].view, farthest[i].triangle,
                               selection.seed, selection.quick ? " --quick" : "")});
  }
  add_accuracy_notes(table);
  table.add_note(fmt::format("Seed {}; at most {} triangles per view, evenly spaced.",
                             selection.seed, options.triangles_per_view));
  table.add_note(machine_description());
  context.emit(table);
  context.emit(worst);
}

}  // namespace clipscope::experiments

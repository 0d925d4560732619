// SPDX-License-Identifier: GPL-3.0-or-later
//
// Accuracy: scenes x clippers x scalars against the exact frustum (T_frustum).
#include <fmt/format.h>

#include <algorithm>

#include "experiments/accuracy/rows.hpp"
#include "experiments/machine/machine.hpp"
#include "experiments/report/experiment.hpp"
#include "experiments/store/piece_record.hpp"
#include "experiments/survey/draw_scene.hpp"

namespace clipscope::experiments::accuracy {
namespace {

void measure_scene(const Scene& scene, const Selection& selection, const AccuracyOptions& options,
                   TableOf<Row>& all, TableOf<WorstRow>& worst_rows, PieceRecord& record) {
  const Contestants contestants = selected_contestants(selection);
  std::vector<AccuracyTally> tallies(contestants.size());
  Progress progress(fmt::format("accuracy on {}", scene.name), sampled_triangles(scene, options));
  measure_accuracy(scene, contestants, options, tallies, progress);
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    const std::string clipper(contestants[i]->clipper), scalar(contestants[i]->scalar());
    all.add({scene.name, clipper, scalar, AccuracyFigures(tallies[i])});
    const Worst& worst = tallies[i].worst_position;
    if (worst.error == 0) continue;
    worst_rows.add({scene.name, clipper, scalar, worst.error, worst.view, worst.triangle});
    const View& view = find_view(scene, worst.view);
    const auto triangles = sampled_view_triangles(scene, view, {1, 1}, worst.triangle, 1);
    record.worst_inputs.push_back(
        worst_input(selection, scene, *contestants[i],
                    {view, triangles.front(), worst.triangle, "position_px", worst.error}));
  }
}

void run(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  const AccuracyOptions options{.triangles_per_view = selection.sample_or(200, 1500)};
  TableOf<Row> all;
  TableOf<WorstRow> worst;
  for (const std::string& name : scene_names(selection)) {
    context.piece(name, {&all, &worst}, [&](PieceRecord& record) {
      measure_scene(load_selected_scene(selection, name), selection, options, all, worst, record);
    });
  }
  all.add_note(fmt::format("Seed {}; at most {} triangles per view, evenly spaced.", selection.seed,
                           options.triangles_per_view));
  all.add_note(machine_description());
  worst.add_note(fmt::format(
      "Shown digit by digit by: clipscope explain --scene SCENE --view VIEW --triangle TRIANGLE --clipper CLIPPER --scalar SCALAR --seed {}{}",
      selection.seed, selection.quick ? " --quick" : ""));
  context.emit(all, worst);
  const Plot plot = error_plot(all.rows());
  if (!plot.series.empty()) context.emit(plot);
  context.finding(finding(all.rows()));
}

}  // namespace

extern constinit const Experiment kExperiment{
    "accuracy", "How far from the exact answer is each clipper, and in what way?", run};

}  // namespace clipscope::experiments::accuracy

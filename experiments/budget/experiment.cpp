// SPDX-License-Identifier: GPL-3.0-or-later
//
// Error budget: the same answers judged by two truths. Against T_frustum they carry every error; against
// T_matrix, the float matrix as given, the rounding of the matrix is forgiven. What the exact scalar
// still misses T_matrix by is the matrix alone.
#include <fmt/format.h>

#include "experiments/experiment.hpp"
#include "experiments/measure/accuracy.hpp"
#include "experiments/measure/machine.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kDefaultSample = 500;  // triangles per view
constexpr std::size_t kQuickSample = 100;

std::vector<AccuracyTally> tallies_for(const Scene& scene, const Selection& selection,
                                       std::span<const AnyContestant> contestants,
                                       reference::TruthKind truth) {
  const std::size_t sample = selection.quick ? kQuickSample : kDefaultSample;
  const AccuracyOptions options{
      .truth = truth, .triangles_per_view = selection.sample != 0 ? selection.sample : sample};
  std::vector<AccuracyTally> tallies(contestants.size());
  Progress progress(fmt::format("budget on {}", scene.name), sampled_triangles(scene, options));
  measure_accuracy(scene, contestants, options, tallies, progress);
  return tallies;
}

}  // namespace

void run_budget(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  const std::vector<AnyContestant> contestants = select_contestants(selection.clipper, {"float"});
  Table table("budget",
              "Error of float clippers: everything, and with the matrix's rounding forgiven",
              {{"scene", "scene"},
               {"clipper", "clipper"},
               {"frustum_median_px", "T_frustum median px"},
               {"frustum_max_px", "max px"},
               {"matrix_median_px", "T_matrix median px"},
               {"matrix_max_px", "max px"}});
  for (const std::string& name : scene_names(selection)) {
    const Scene scene = load_selected_scene(selection, name);
    const auto everything =
        tallies_for(scene, selection, contestants, reference::TruthKind::frustum);
    const auto forgiven = tallies_for(scene, selection, contestants, reference::TruthKind::matrix);
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      table.add_row({scene.name, std::string(clipper_name(contestants[i])),
                     everything[i].position_px.quantile(0.5), everything[i].position_px.max(),
                     forgiven[i].position_px.quantile(0.5), forgiven[i].position_px.max()});
    }
  }
  table.add_note(
      "T_frustum: exact frustum numbers. T_matrix: the float projection matrix as given. "
      "Their difference is what rounding the matrix costs; what stays under T_matrix is "
      "transform, cut and divide.");
  table.add_note(machine_description());
  context.emit(table);
}

}  // namespace clipscope::experiments

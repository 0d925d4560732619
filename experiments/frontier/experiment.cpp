// SPDX-License-Identifier: GPL-3.0-or-later
//
// Frontier: sets of triangles x clippers x scalars, judged and timed on the same triangles in the same
// run; who is not beaten in both, and what the next step costs.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "experiments/experiment.hpp"
#include "experiments/frontier/contest.hpp"
#include "experiments/frontier/plots.hpp"
#include "experiments/frontier/rounding_stages.hpp"
#include "experiments/frontier/tables.hpp"
#include "experiments/measure/machine.hpp"
#include "experiments/measure/worst_input.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kTriangles = 6000;  // per set, over all its views
constexpr std::size_t kQuickTriangles = 300;

// Game-like, all straddling, hard.
std::vector<std::string> sets(const Selection& selection) {
  if (!selection.scenes.empty()) return selection.scenes;
  return {"soup", "soup_straddling", "slivers"};
}

std::size_t triangle_limit(const Selection& selection, const Scene& scene) {
  if (selection.sample != 0) return selection.sample * scene.views.size();
  return selection.quick ? kQuickTriangles : kTriangles;
}

void record_samples(const std::string& set, std::span<const Entry> entries, CellRecord& record) {
  for (const Entry& e : entries) {
    if (!e.timing.refused.empty()) continue;
    record.samples.push_back({fmt::format("{} {} {} {}", set, e.contract, e.clipper, e.scalar),
                              "ns per triangle", e.timing.samples_ns});
  }
}

// The stage's frontiers on the same triangles, in clip space by the float transform.
void add_stage(const Selection& selection, const Scene& scene, const TimingOptions& timing,
               std::array<Table*, 3> tables, CellRecord& record) {
  const StageInput input = scene_input(scene, triangle_limit(selection, scene));
  const StageTimingOptions options{.rounds = timing.rounds,
                                   .milliseconds_per_run = timing.milliseconds_per_run,
                                   .check = {.exact = timing.checked_triangles}};
  const std::vector<AnyContestant> selected = selected_contestants(selection);
  const auto is_selected = [&](std::string_view clipper) {
    return std::any_of(selected.begin(), selected.end(), [&](const AnyContestant& contestant) {
      return clipper_name(contestant) == clipper;
    });
  };
  for (const std::vector<Entry>& entries : hold_stage_contest(input, is_selected, options)) {
    add_frontier_rows(scene.name, entries, *tables[0]);
    add_step_rows(scene.name, entries, *tables[1]);
    add_refused_rows(scene.name, entries, *tables[2]);
    record_samples(scene.name, entries, record);
  }
}

void record_entries(const Selection& selection, const Scene& scene,
                    std::span<const TimedBatch> batches, std::span<const AnyContestant> contestants,
                    std::span<const Entry> entries, CellRecord& record) {
  record_samples(scene.name, entries, record);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Entry& e = entries[i];
    if (!(e.accuracy.error_px.max() > 0)) continue;
    const TimedBatch& batch = batches[e.accuracy.worst_batch];
    const std::size_t triangle = e.accuracy.worst_triangle;
    record.worst_inputs.push_back(
        worst_input(selection, scene, contestants[i],
                    {batch.view, batch.triangles[triangle], batch.numbers[triangle],
                     "distance on screen [px]", e.accuracy.error_px.max()}));
  }
}

}  // namespace

void run_frontier(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  const std::vector<AnyContestant> contestants = selected_contestants(selection);
  const TimingOptions options{.rounds = selection.quick ? 5 : 31,
                              .milliseconds_per_run = selection.quick ? 0.3 : 2.0,
                              .checked_triangles = selection.quick ? 24u : 256u};
  Table frontier = frontier_table(), steps = frontier_steps_table(),
        refused = frontier_refused_table(), rounding = rounding_stages_table();
  for (const std::string& name : sets(selection)) {
    context.cell("set " + name, {&frontier, &steps, &refused, &rounding}, [&](CellRecord& record) {
      const Scene scene = load_selected_scene(selection, name);
      const auto batches = timed_batches(scene, triangle_limit(selection, scene));
      std::size_t triangles = 0;
      for (const TimedBatch& batch : batches) triangles += batch.triangles.size();
      Progress progress("frontier on " + scene.name, triangles * contestants.size());
      const std::vector<Entry> entries = hold_contest(batches, contestants, options, progress);
      add_frontier_rows(scene.name, entries, frontier);
      add_step_rows(scene.name, entries, steps);
      add_refused_rows(scene.name, entries, refused);
      record_entries(selection, scene, batches, contestants, entries, record);
      add_rounding_stage_rows(scene.name, batches, rounding);
      add_stage(selection, scene, options, {&frontier, &steps, &refused}, record);
    });
  }
  frontier.add_note(machine_description());
  steps.add_note(machine_description());
  context.emit(frontier);
  context.emit(steps);
  context.emit(rounding);
  if (!refused.rows().empty()) context.emit(refused);
  for (const std::string& set : sets_of(frontier)) {
    for (const ErrorMeasure measure : kErrorMeasures) {
      context.emit(frontier_plot(set, measure, frontier));
      if (measure == ErrorMeasure::wrong) continue;
      for (const char* contract : {"copy", "reference"}) {
        const Plot plot = frontier_plot(set, measure, frontier, contract);
        if (!plot.series.back().x.empty()) context.emit(plot);
      }
    }
  }
  context.finding(frontier_finding(frontier, steps));
}

}  // namespace clipscope::experiments

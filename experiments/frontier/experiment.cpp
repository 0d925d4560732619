// SPDX-License-Identifier: GPL-3.0-or-later
//
// Frontier: sets of triangles x clippers x scalars, judged and timed on the same triangles in the
// same run; who is not beaten in both, and what the next step costs.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "experiments/frontier/rows.hpp"
#include "experiments/machine/machine.hpp"
#include "experiments/report/experiment.hpp"
#include "experiments/store/piece_record.hpp"

namespace clipscope::experiments::frontier {
namespace {

constexpr std::size_t kTriangles = 6000;  // per set, over all its views
constexpr std::size_t kQuickTriangles = 300;
constexpr std::size_t kTimedInStage = 500'000, kQuickTimedInStage = 40'000;
// Who is twice as slow as somebody at most as inaccurate is on no frontier.
constexpr double kFar = 2;

struct Tables {
  TableOf<Row> frontier;
  TableOf<StepRow> steps;
  TableOf<RefusedRow> refused;
  TableOf<RoundingRow> rounding;

  void add(const std::string& set, std::span<const Entry> entries, PieceRecord& record) {
    add_rows(set, entries, frontier);
    add_rows(set, entries, steps);
    add_rows(set, entries, refused);
    for (const Entry& e : entries) {
      record.add(fmt::format("{} {} {} {} {}", set, name_of(e.contestant->contract),
                             name_of(e.from), e.contestant->clipper, e.contestant->scalar()),
                 e.timing);
    }
  }
};

std::size_t triangle_limit(const Selection& selection, const Scene& scene) {
  if (selection.sample != 0) return selection.sample * scene.views.size();
  return selection.quick ? kQuickTriangles : kTriangles;
}

void record_worst(const Selection& selection, const Scene& scene,
                  std::span<const SampledView> views, std::span<const Entry> entries,
                  PieceRecord& record) {
  for (const Entry& e : entries) {
    if (!(e.accuracy.error_px.max() > 0)) continue;
    const SampledView& v = views[e.accuracy.worst_view];
    const std::size_t triangle = e.accuracy.worst_triangle;
    record.worst_inputs.push_back(
        worst_input(selection, scene, *e.contestant,
                    {v.view, v.triangles[triangle], v.numbers[triangle], "distance on screen [px]",
                     e.accuracy.error_px.max()}));
  }
}

void measure_set(const Selection& selection, const std::string& name,
                 const Contestants& contestants, Tables& tables, PieceRecord& record) {
  const Scene scene = load_selected_scene(selection, name);
  ContestClock clock = contest_clock(selection.quick);
  clock.far = kFar;
  const std::size_t limit = triangle_limit(selection, scene);
  const auto views = sampled_views(scene, limit);
  std::size_t triangles = 0;
  for (const SampledView& v : views) triangles += v.triangles.size();
  Progress progress("frontier on " + scene.name, triangles * contestants.size());
  const std::vector<Entry> entries = hold_contest(views, contestants, clock, progress);
  tables.add(scene.name, entries, record);
  record_worst(selection, scene, views, entries, record);
  add_rows(scene.name, views, tables.rounding);
  // The stage's frontiers on the same triangles, in clip space by the float transform.
  const StageClock stage_clock{.rounds = clock.rounds,
                               .milliseconds_per_run = clock.milliseconds_per_run,
                               .check = {.exact = clock.checked}};
  Contestants in_stage = contestants;
  std::ranges::copy(stage_only_contestants(selection.clipper), std::back_inserter(in_stage));
  const std::size_t timed = selection.quick ? kQuickTimedInStage : kTimedInStage;
  for (const auto& stage :
       hold_stage_contest(scene_input(scene, limit), in_stage, timed, stage_clock)) {
    tables.add(scene.name, stage, record);
  }
}

void emit_plots(const ExperimentContext& context, const std::vector<Row>& rows) {
  for (const std::string& set : distinct(rows, &Row::set)) {
    for (const Measure measure : kMeasures) {
      context.emit(frontier_plot(rows, {set, measure}));
      if (measure == Measure::wrong) continue;
      for (const Contract contract : {Contract::copy, Contract::number}) {
        const Plot plot = frontier_plot(rows, {set, measure, contract});
        if (!plot.series.back().x.empty()) context.emit(plot);
      }
    }
  }
}

void run(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  const Contestants contestants = selected_contestants(selection);
  Tables tables;
  auto& [frontier, steps, refused, rounding] = tables;
  // Game-like, cut by one plane mostly, by several, hard.
  for (const std::string& name :
       selection.scenes_or({"soup", "soup_straddling", "soup_several_planes", "slivers"})) {
    context.piece(
        "set " + name, {&frontier, &steps, &refused, &rounding},
        [&](PieceRecord& record) { measure_set(selection, name, contestants, tables, record); });
  }
  frontier.add_note(timing_description());
  steps.add_note(machine_description());
  context.emit(frontier, steps, rounding);
  if (!refused.rows().empty()) context.emit(refused);
  emit_plots(context, frontier.rows());
  context.finding(finding(frontier.rows()));
}

}  // namespace

extern constinit const Experiment kExperiment{
    "frontier", "What does accuracy cost in time: who is not beaten in both?", run};

}  // namespace clipscope::experiments::frontier

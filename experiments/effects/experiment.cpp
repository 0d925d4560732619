// SPDX-License-Identifier: GPL-3.0-or-later
//
// Effects: scenes x (full pipeline, planned pipeline, transform and divide alone), what each scene calls
// for and why, what leaving the rest out changes, and what it saves.
#include <fmt/format.h>

#include <cmath>

#include "experiments/effects/harm.hpp"
#include "experiments/effects/plan_table.hpp"
#include "experiments/effects/tables.hpp"
#include "experiments/effects/time_planned.hpp"
#include "experiments/experiment.hpp"
#include "experiments/measure/machine.hpp"
#include "experiments/report/progress.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kTriangles = 100000;  // per view, unless --sample says otherwise

std::vector<std::string> scenes_of(const Selection& selection) {
  std::vector<std::string> names = scene_names(selection);
  if (selection.scenes.empty()) {
    for (const std::string& name : lean_scene_names()) names.push_back(name);
  }
  return names;
}

Harm harm_of_all(std::span<const PlannedView> views) {
  Harm all;
  for (const PlannedView& view : views) {
    const Harm harm = harm_of(view.plan, view.triangles);
    all.polygons += harm.polygons;
    all.changed += harm.changed;
    all.attribute_error = std::max(all.attribute_error, harm.attribute_error);
  }
  return all;
}

void measure_scene(const Selection& selection, const std::string& name, EffectTables& tables,
                   CellRecord& record) {
  const NeededScene needed = load_needed_scene(selection, name);
  const std::size_t limit = selection.sample > 0 ? selection.sample : kTriangles;
  const std::vector<PlannedView> views = plan_views(needed, {}, limit);
  for (const PlanLine& line : plan_lines(views)) {
    tables.plans.add_row({needed.scene.name, line.effect, line.called_for, line.because});
  }
  const Harm harm = harm_of_all(views);
  if (harm.changed > 0 || !(harm.attribute_error <= PlanSettings{}.tolerance)) {
    tables.add_row(needed.scene.name, called_for_in_short(views), harm, nullptr);
    return;
  }
  const PlannedTiming timing = time_planned(
      views,
      {.rounds = selection.quick ? 9 : 51, .milliseconds_per_run = selection.quick ? 1. : 3.});
  tables.add_row(needed.scene.name, called_for_in_short(views), harm, &timing);
  record.samples = {{needed.scene.name + " full", "ns/triangle", timing.full_samples},
                    {needed.scene.name + " planned", "ns/triangle", timing.planned_samples},
                    {needed.scene.name + " bare", "ns/triangle", timing.bare_samples}};
}

}  // namespace

void run_effects(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  EffectTables tables;
  const std::vector<std::string> names = scenes_of(selection);
  Progress progress("effects", names.size());
  for (const std::string& name : names) {
    context.cell("scene " + name, {&tables.times, &tables.plans},
                 [&](CellRecord& record) { measure_scene(selection, name, tables, record); });
    progress.advance();
  }
  tables.add_notes(PlanSettings{}.tolerance, machine_description());
  context.emit(tables.times);
  context.emit(tables.plans);
  context.emit(plot_of(tables.times));
  context.finding(finding_of(tables.times));
}

}  // namespace clipscope::experiments

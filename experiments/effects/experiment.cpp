// SPDX-License-Identifier: GPL-3.0-or-later
//
// Effects: scenes x (full pipeline, planned pipeline, transform and divide alone), what each scene
// calls for and why, what leaving the rest out changes, and what it saves.
#include <fmt/format.h>

#include <algorithm>

#include "experiments/effects/rows.hpp"
#include "experiments/machine/machine.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/report/experiment.hpp"

namespace clipscope::experiments::effects {
namespace {

constexpr std::size_t kTriangles = 100000;  // per view, unless --sample says otherwise

void measure_scene(const Selection& selection, const std::string& name, TableOf<Row>& rows,
                   TableOf<PlanRow>& plans, PieceRecord& record) {
  const NeededScene needed = load_needed_scene(selection, name);
  const std::string& scene = needed.scene.name;
  const std::vector<PlannedView> views =
      plan_views(needed, {}, selection.sample > 0 ? selection.sample : kTriangles);
  for (const PlanLine& line : plan_lines(views)) plans.add({scene, line});
  const Harm harm = harm_of(views);
  const Timings timings = time_planned(
      views, harm,
      {.rounds = selection.quick ? 9 : 51, .milliseconds_per_run = selection.quick ? 1.0 : 3.0});
  Row row{scene, std::nullopt, harm, called_for_in_short(views)};
  if (timings.full.is_timed() && timings.planned.is_timed()) {
    row.times = Times(timings);
    record.add(scene + " full", timings.full);
    record.add(scene + " planned", timings.planned);
    record.add(scene + " bare", timings.bare);
  }
  rows.add(row);
}

void run(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  TableOf<Row> rows;
  TableOf<PlanRow> plans;
  const std::vector<std::string> names = needed_scene_names(selection);
  Progress progress("effects", names.size());
  for (const std::string& name : names) {
    context.piece("scene " + name, {&rows, &plans}, [&](PieceRecord& record) {
      measure_scene(selection, name, rows, plans, record);
    });
    progress.advance();
  }
  rows.add_note(fmt::format(
      "changed: polygons that differ from the full pipeline's in any bit that the plan keeps. Max attribute error: where perspective correction is left out; tolerance {}. Not timed (-): the answers are wrong.",
      format_number(PlanSettings{}.tolerance)));
  rows.add_note(machine_description());
  context.emit(rows, plans, time_plot(rows.rows()));
  context.finding(finding(rows.rows()));
}

}  // namespace

Times::Times(const Timings& t)
    : full_ns(t.full.ns.median),
      planned_ns(t.planned.ns.median),
      bare_ns(t.bare.ns.median),
      facts_ns(t.facts.ns.median),
      mesh_facts_ns(t.attributes.ns.median),
      to_full(median_interval(ratios(t.planned.samples_ns, t.full.samples_ns))),
      to_bare(median_interval(ratios(t.planned.samples_ns, t.bare.samples_ns))) {
  if (planned_ns < full_ns) facts_to_saved = facts_ns / (full_ns - planned_ns);
}

Plot time_plot(const std::vector<Row>& rows) {
  Plot plot{
      .name = "effects",
      .title = "Time with all effects, with those called for, and with none",
      .caption =
          "The planned pipeline takes at most as long as the full one; where a scene is all inside, as long as transform and divide alone, and less where it needs no divide.",
      .x = {.label = ""},
      .y = {.label = "ns per triangle"},
      .categories = distinct(rows, &Row::scene)};
  for (const auto& [name, ns] :
       {std::pair{"full", &Times::full_ns}, std::pair{"planned", &Times::planned_ns},
        std::pair{"transform and divide", &Times::bare_ns}}) {
    const auto bar = [ns = ns](const Row& row) {
      return row.times ? std::optional((*row.times).*ns) : std::nullopt;
    };
    add_bars(plot, name, rows, bar, &Row::scene);
  }
  plot.series.front().muted = true;
  return plot;
}

std::string finding(const std::vector<Row>& rows) {
  Harm all;
  for (const Row& row : rows) all += row.harm;
  std::vector<Row> timed = rows;
  std::erase_if(timed, [](const Row& row) { return !row.times; });
  const std::string text = fmt::format(
      "Leaving out what a scene does not call for changes {} of {} polygons and attributes by {} at most",
      all.changed, all.polygons, format_number(all.attribute_error));
  if (timed.empty()) return text + ".";
  const auto to_full = [](const Row& row) { return row.times->to_full.median; };
  const auto to_bare = [](const Row& row) { return row.times->to_bare.median; };
  const Row& best = *std::ranges::min_element(timed, {}, to_full);
  const Row& worst = *std::ranges::max_element(timed, {}, to_full);
  const Row& barest = *std::ranges::min_element(timed, {}, to_bare);
  return text +
         fmt::format(
             "; it takes {:.2f} of the full pipeline's time on {} and {:.2f} on {}, and {:.2f} times that of transform and divide alone on {}.",
             to_full(best), best.scene, to_full(worst), worst.scene, to_bare(barest), barest.scene);
}

extern constinit const Experiment kExperiment{
    "effects", "Which effects does a scene call for, and what does leaving out the rest save?",
    run};

}  // namespace clipscope::experiments::effects

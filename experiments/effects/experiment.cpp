// SPDX-License-Identifier: GPL-3.0-or-later
//
// Effects: scenes x (full pipeline, planned pipeline, transform and divide alone), what each scene
// calls for and why, what leaving the rest out changes, and what it saves.
#include <fmt/format.h>

#include <algorithm>

#include "experiments/contestants/spoken.hpp"
#include "experiments/effects/rows.hpp"
#include "experiments/machine/machine.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/report/experiment.hpp"
#include "experiments/table/prose.hpp"

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
  rows.add_note(timing_description());
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

namespace {

std::string harm_sentence(const std::vector<Row>& rows) {
  Harm all;
  for (const Row& row : rows) all += row.harm;
  if (all.changed > 0) {
    return fmt::format("Leaving out what a scene does not call for CHANGES {} of {} polygons.",
                       all.changed, all.polygons);
  }
  return fmt::format(
      "Leaving out what a scene does not call for changes no polygon, and attributes {}.",
      all.attribute_error <= PlanSettings{}.tolerance ? "by no more than the tolerance"
                                                      : "by MORE than the tolerance");
}

// The share of the full pipeline's time that is saved, on the scenes where that is most and least.
std::string time_sentence(const std::vector<Row>& timed) {
  const auto saved = [](const Row& row) { return 100 * (1 - row.times->to_full.median); };
  const auto [least, most] = std::ranges::minmax_element(timed, {}, saved);
  std::string text = fmt::format(" It saves {:.0f} % of the full pipeline's time on {}",
                                 saved(*most), spoken_set(most->scene));
  if (least == most) return text + ".";
  const std::string on = spoken_set(least->scene);
  if (least->times->to_full.low > 1) return fmt::format("{}, and costs time on {}.", text, on);
  if (least->times->to_full.high >= 1) return fmt::format("{}, and nothing on {}.", text, on);
  return fmt::format("{}, and {:.0f} % on {}.", text, saved(*least), on);
}

// Where even transform and divide alone take longer.
std::string bare_sentence(const std::vector<Row>& timed) {
  std::vector<std::string> faster;
  for (const Row& row : timed) {
    if (row.times->to_bare.high < 1) faster.push_back(spoken_set(row.scene));
  }
  if (faster.empty()) return "";
  return fmt::format(" On {} it is faster than transform and divide alone, of which it needs less.",
                     listed(faster));
}

}  // namespace

std::string finding(const std::vector<Row>& rows) {
  if (rows.empty()) return "No scene was looked at.";
  std::vector<Row> timed = rows;
  std::erase_if(timed, [](const Row& row) { return !row.times; });
  if (timed.empty()) return harm_sentence(rows);
  return harm_sentence(rows) + time_sentence(timed) + bare_sentence(timed);
}

extern constinit const Experiment kExperiment{
    "effects", "Which effects does a scene call for, and what does leaving out the rest save?",
    run};

}  // namespace clipscope::experiments::effects

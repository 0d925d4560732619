// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/effects/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "experiments/report/row_view.hpp"

namespace clipscope::experiments {
namespace {

// A measured number of a row; NaN where it was not measured.
double number(const RowView& row, std::string_view key) {
  return row.find_number(key).value_or(std::nan(""));
}

}  // namespace

EffectTables::EffectTables()
    : times("effects", "What a scene calls for, and the time of a pipeline of just that (float)",
            {{"scene", "scene"},
             {"full_ns_per_triangle", "full ns/tri"},
             {"planned_ns_per_triangle", "planned ns/tri"},
             {"planned_to_full", "/ full"},
             {"planned_to_full_low", "95 % low"},
             {"planned_to_full_high", "high"},
             {"bare_ns_per_triangle", "bare ns/tri"},
             {"planned_to_bare", "/ bare"},
             {"planned_to_bare_low", "95 % low"},
             {"planned_to_bare_high", "high"},
             {"facts_ns_per_triangle", "facts ns/tri"},
             {"facts_to_saved", "facts / saved"},
             {"mesh_facts_ns_per_triangle", "mesh facts ns/tri"},
             {"polygons", "polygons"},
             {"changed_polygons", "changed"},
             {"max_attribute_error", "max attribute error"},
             {"effects_called_for", "effects called for"}}),
      plans("effects_plan", "Which effects each scene calls for, and why",
            {{"scene", "scene"},
             {"effect", "effect"},
             {"called_for", "called for?"},
             {"because", "because"}}) {}

void EffectTables::add_row(const std::string& scene, const std::string& called_for,
                           const Harm& harm, const PlannedTiming* timing) {
  std::vector<Cell> cells = {scene};
  if (timing != nullptr) {
    const PlannedTiming& t = *timing;
    cells.insert(cells.end(), {t.full_ns.median, t.planned_ns.median, t.to_full.median,
                               t.to_full.low, t.to_full.high, t.bare_ns.median, t.to_bare.median,
                               t.to_bare.low, t.to_bare.high, t.facts_ns.median});
    const double saved = t.full_ns.median - t.planned_ns.median;
    if (saved > 0) {
      cells.emplace_back(t.facts_ns.median / saved);
    } else {
      cells.emplace_back();
    }
    cells.emplace_back(t.attributes_ns.median);
  } else {
    cells.resize(times.columns().size() - 4);
  }
  cells.insert(cells.end(),
               {static_cast<std::int64_t>(harm.polygons), static_cast<std::int64_t>(harm.changed),
                harm.attribute_error, called_for});
  times.add_row(std::move(cells));
}

void EffectTables::add_notes(double tolerance, const std::string& machine) {
  times.add_note(
      "full: homogeneous/sutherland_hodgman. planned: what each view calls for, planned by itself. "
      "bare: transform and divide alone, nothing clipped. Ratios: median over rounds, 95 % "
      "interval.");
  times.add_note(
      "facts: the look at a view from which its plan is made; facts / saved: in how many frames "
      "with "
      "the same facts that look is paid for. mesh facts: the look at attributes, once per mesh.");
  times.add_note(fmt::format(
      "changed: polygons that differ from the full pipeline's in any bit that the plan keeps. Max "
      "attribute error: where perspective correction is left out; tolerance {}. Not timed (-): the "
      "answers are wrong.",
      format_number(tolerance)));
  times.add_note(machine);
  plans.add_note(
      "Over all views of a scene: the view that calls for most. test: what is outside is dropped, "
      "nothing is cut.");
}

Plot plot_of(const Table& times) {
  Plot plot{.name = "effects",
            .title = "Time with all effects, with those called for, and with none",
            .caption =
                "The planned pipeline takes at most as long as the full one; where a scene is all "
                "inside, as long as transform and divide alone, and less where it needs no "
                "divide.",
            .x = {.label = ""},
            .y = {.label = "ns per triangle"},
            .series = {{.name = "full", .x = {}, .y = {}, .muted = true},
                       {.name = "planned", .x = {}, .y = {}},
                       {.name = "transform and divide", .x = {}, .y = {}}}};
  for (const RowView& row : rows_of(times)) {
    plot.categories.push_back(row.text("scene"));
    plot.series[0].y.push_back(number(row, "full_ns_per_triangle"));
    plot.series[1].y.push_back(number(row, "planned_ns_per_triangle"));
    plot.series[2].y.push_back(number(row, "bare_ns_per_triangle"));
  }
  return plot;
}

std::string finding_of(const Table& times) {
  double changed = 0, polygons = 0, error = 0;
  std::optional<RowView> best, worst, barest;
  const auto prefer = [&](std::optional<RowView>& chosen, const RowView& row, std::string_view key,
                          double sign) {
    const double value = sign * number(row, key);
    if (!std::isnan(value) && (!chosen || value < sign * number(*chosen, key))) {
      chosen = row;
    }
  };
  for (const RowView& row : rows_of(times)) {
    changed += number(row, "changed_polygons");
    polygons += number(row, "polygons");
    error = std::max(error, number(row, "max_attribute_error"));
    prefer(best, row, "planned_to_full", 1);
    prefer(worst, row, "planned_to_full", -1);
    prefer(barest, row, "planned_to_bare", 1);
  }
  std::string text = fmt::format(
      "Leaving out what a scene does not call for changes {:.0f} of {:.0f} polygons and attributes "
      "by "
      "{} at most",
      changed, polygons, format_number(error));
  if (!best) return text + ".";
  return text + fmt::format(
                    "; it takes {:.2f} of the full pipeline's time on {} and {:.2f} on {}, and "
                    "{:.2f} times "
                    "that of transform and divide alone on {}.",
                    number(*best, "planned_to_full"), best->text("scene"),
                    number(*worst, "planned_to_full"), worst->text("scene"),
                    number(*barest, "planned_to_bare"), barest->text("scene"));
}

}  // namespace clipscope::experiments

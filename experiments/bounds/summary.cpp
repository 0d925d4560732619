// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/bounds/rows.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace clipscope::experiments::bounds {
namespace {

// A set of bars for each bound over the scenes.
template <class Figure>
Plot bars(Plot plot, const std::vector<Row>& all, const Figure& figure) {
  const std::vector<Row> rows = rows_where(all, &Row::clipper, all.front().clipper);
  plot.categories = distinct(rows, &Row::place);
  for (const std::string& bound : distinct(rows, &Row::bound)) {
    add_bars(plot, bound, rows, figure, &Row::place, &Row::bound, bound);
  }
  return plot;
}

std::string where(const Row& row) { return row.place() + ", " + row.bound; }

}  // namespace

Plot settled_plot(const std::vector<Row>& rows) {
  Plot plot = bars(
      {.name = "bounds",
       .title = "Objects that a bounding volume settles",
       .caption =
           "Share of objects that are rejected or accepted before any triangle is looked at; grey: what exact arithmetic settles, triangle by triangle, the most that any bound could.",
       .x = {},
       .y = {.label = "objects settled [%]", .from = 0, .to = 100}},
      rows, &Row::settled_percent);
  add_bars(plot, "exact arithmetic", rows, &Row::settleable_percent, &Row::place).muted = true;
  return plot;
}

Plot speedup_plot(const std::vector<Row>& rows) {
  return bars(
      {.name = "bounds_speedup",
       .title = "Clipping with bounding volumes: how many times faster",
       .caption =
           "All triangles of all views, testing the volumes included, against clipping every triangle; median and 95 % interval. Below 1: slower.",
       .x = {},
       .y = {.label = "speedup", .from = 0}},
      rows, &Row::speedup);
}

std::string finding(const std::vector<Row>& rows) {
  if (rows.empty()) return "";
  std::int64_t judged = 0, lost = 0, cut = 0;
  for (const Row& row : rows) {
    judged += row.judged_triangles;
    lost += row.visible_lost;
    cut += row.accepted_cut;
  }
  const Row& least = *std::ranges::min_element(rows, {}, &Row::settled_percent);
  const Row& most = *std::ranges::max_element(rows, {}, &Row::settled_percent);
  std::string finding = fmt::format(
      "Bounds settle {:.0f} % ({}) to {:.0f} % ({}) of the objects, and leave up to {:.0f} % of the triangles untouched; of {} exact verdicts {} on rejected objects find something visible, {} on accepted ones something to cut.",
      least.settled_percent(), where(least), most.settled_percent(), where(most),
      std::ranges::max(rows, {}, &Row::untouched_percent).untouched_percent, judged, lost, cut);
  const auto speedup = [](const Row& row) { return row.speedup->median; };
  const std::vector<Row> timed = rows_where(rows, &Row::polygons, kSame);
  if (!timed.empty()) {
    const Row& slowest = *std::ranges::min_element(timed, {}, speedup);
    const Row& fastest = *std::ranges::max_element(timed, {}, speedup);
    finding += fmt::format(" Clipping gets {:.2f} times ({}) to {:.2f} times ({}) as fast.",
                           speedup(slowest), where(slowest), speedup(fastest), where(fastest));
  }
  return finding;
}

}  // namespace clipscope::experiments::bounds

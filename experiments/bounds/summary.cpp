// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/bounds/rows.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/contestants/spoken.hpp"
#include "experiments/table/prose.hpp"

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

constexpr double kNoticeable = 1.05;  // a smaller speedup is none

double speedup_of(const Row& row) { return row.speedup->median; }

// What is lost is an error of a bound, and so is an accepted object of which something is cut.
std::string settled_sentence(const std::vector<Row>& rows) {
  std::int64_t lost = 0, cut = 0;
  for (const Row& row : rows) {
    lost += row.visible_lost;
    cut += row.accepted_cut;
  }
  const auto [least, most] = std::ranges::minmax_element(rows, {}, &Row::settled_percent);
  std::string text = fmt::format(
      "Bounding volumes settle up to {:.0f} % of the objects without a look at their triangles, on {}",
      most->settled_percent(), spoken_set(most->scene));
  if (least->scene != most->scene) {
    text += fmt::format(", and as few as {:.0f} % on {}", least->settled_percent(),
                        spoken_set(least->scene));
  }
  return fmt::format("{}. They {}.", text,
                     lost > 0  ? "are WRONG: something visible is rejected"
                     : cut > 0 ? "are WRONG: something that a plane cuts is accepted"
                               : "lose nothing that is visible");
}

// On which scenes some bound makes clipping faster, and which bound that is.
std::string time_sentence(const std::vector<Row>& rows) {
  const std::vector<Row> timed = rows_where(rows, &Row::polygons, kSame);
  if (timed.empty()) return "";
  std::vector<std::string> faster, others;
  for (const std::string& scene : distinct(timed, &Row::scene)) {
    const std::vector<Row> of_scene = rows_where(timed, &Row::scene, scene);
    const Row& best = *std::ranges::max_element(of_scene, {}, speedup_of);
    const bool pays = best.speedup->low > 1 && speedup_of(best) > kNoticeable;
    (pays ? faster : others).push_back(spoken_set(scene));
  }
  if (faster.empty()) return " They make clipping faster on no scene.";
  const Row& best = *std::ranges::max_element(timed, {}, speedup_of);
  std::string text = fmt::format(" They make clipping faster on {}", listed(faster));
  if (!others.empty()) text += fmt::format(", but not on {}", listed(others));
  return fmt::format("{}. The largest gain is that of the {}.", text, best.bound);
}

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
  if (rows.empty()) return "No clipper was asked for.";
  return settled_sentence(rows) + time_sentence(rows);
}

}  // namespace clipscope::experiments::bounds

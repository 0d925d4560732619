// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/segments/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "experiments/contestants/spoken.hpp"
#include "experiments/table/prose.hpp"

namespace clipscope::experiments::segments {
namespace {

constexpr const char* kCohenSutherland = "homogeneous/cohen_sutherland";
constexpr const char* kPublished = "homogeneous/liang_barsky";
constexpr const char* kProducts = "homogeneous/liang_barsky_division_free";

// Bars of more clippers than these can't be told apart.
constexpr std::array kShown = {kCohenSutherland,
                               kPublished,
                               kProducts,
                               "view/cyrus_beck",
                               "cvv/cohen_sutherland",
                               "window/nicholl_lee_nicholl"};

// Fills the plot with bars by mix, a set for each clipper.
template <class Row, class Figure>
Plot with_bars(Plot plot, const std::vector<Row>& rows, const Figure& figure) {
  plot.categories = distinct(rows, &Row::mix);
  std::vector<std::string> clippers = distinct(rows, &Row::clipper);
  if (clippers.size() > kShown.size()) clippers.assign(kShown.begin(), kShown.end());
  for (const std::string& clipper : clippers) {
    add_bars(plot, clipper, rows, figure, &Row::mix, &Row::clipper, clipper);
  }
  return plot;
}

std::vector<TimeRow> timed_in(std::vector<TimeRow> times, const std::string& scalar) {
  std::erase_if(times, [&](const TimeRow& row) { return row.scalar != scalar || !row.timing; });
  return times;
}

double ns_of(const TimeRow& row) { return row.timing->ns.median; }

// The clipper that is the fastest on the most mixes, in `scalar`.
std::string fastest_text(const std::vector<TimeRow>& times, const std::string& scalar) {
  const std::vector<TimeRow> timed = timed_in(times, scalar);
  const std::vector<std::string> mixes = distinct(timed, &TimeRow::mix);
  if (mixes.empty()) return "No line clipper was timed.";
  std::map<std::string, std::int64_t> wins;
  for (const std::string& mix : mixes) {
    const std::vector<TimeRow> rows = rows_where(timed, &TimeRow::mix, mix);
    ++wins[std::ranges::min_element(rows, {}, ns_of)->clipper];
  }
  const auto best = std::ranges::max_element(wins, {}, [](const auto& win) { return win.second; });
  return fmt::format("{} is the fastest line clipper in {} on {}.",
                     capitalised(spoken_clipper(best->first)), spoken_scalar(scalar),
                     some_of(best->second, static_cast<std::int64_t>(mixes.size()), "mixes"));
}

// What Cohen-Sutherland saves by its outcodes and wastes by cutting plane after plane.
std::string intersections_text(const std::vector<OperationsRow>& operations) {
  using R = OperationsRow;
  const auto figure = [&](const char* mix, const char* clipper, R::Figure R::*member) {
    const R* row = find_row(operations, &R::mix, mix, &R::clipper, clipper);
    return row == nullptr ? std::nullopt : row->*member;
  };
  const auto free = figure("window_1_64", kCohenSutherland, &R::rejected_free_percent);
  const auto repeated = figure("cross_several", kCohenSutherland, &R::divisions_per_shortened);
  const auto moved = figure("cross_several", kCohenSutherland, &R::moved_ends_per_shortened);
  const auto once = figure("cross_several", kProducts, &R::divisions_per_shortened);
  if (!free || !repeated || !moved || !once) return "";
  constexpr double kNoticeable = 1.01;
  const bool repeats = *repeated > kNoticeable * *moved, too = *once > kNoticeable * *moved;
  return fmt::format(
      " Cohen-Sutherland rejects {} invisible lines without an intersection where the window is small; where several planes cut, it computes {} intersections than it moves ends, {} Liang-Barsky by products.",
      quantity(*free / 100), repeats ? "more" : "no more", repeats == too ? "like" : "unlike");
}

}  // namespace

Plot time_plot(const std::vector<TimeRow>& times) {
  const std::string scalar = times.empty() ? "" : times.front().scalar;
  return with_bars({.name = "segments",
                    .title = fmt::format("Time per segment by mix ({})", scalar),
                    .caption = "View space in, NDC out, with four attributes.",
                    .x = {},
                    .y = {.label = "time [ns/segment]", .from = 0}},
                   timed_in(times, scalar), ns_of);
}

Plot divisions_plot(const std::vector<OperationsRow>& operations) {
  return with_bars(
      {.name = "segments_divisions",
       .title = "Divisions that cut, per segment by mix",
       .caption =
           "All divisions but the four per vertex of the perspective divide: one for each parameter of an intersection, after the divide one more for the attributes of a new end.",
       .x = {},
       .y = {.label = "divisions per segment", .from = 0}},
      operations, &OperationsRow::cut_divisions);
}

std::string finding(const std::vector<TimeRow>& times,
                    const std::vector<OperationsRow>& operations) {
  return fastest_text(times, times.empty() ? "" : times.front().scalar) +
         intersections_text(operations);
}

}  // namespace clipscope::experiments::segments

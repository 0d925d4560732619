// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/segments/rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

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

// "homogeneous/cohen_sutherland on 5, ...", by how often a clipper is the fastest, in `scalar`.
std::string fastest_text(const std::vector<TimeRow>& times, const std::string& scalar) {
  const std::vector<TimeRow> timed = timed_in(times, scalar);
  const std::vector<std::string> mixes = distinct(timed, &TimeRow::mix);
  std::map<std::string, int> wins;
  for (const std::string& mix : mixes) {
    const std::vector<TimeRow> rows = rows_where(timed, &TimeRow::mix, mix);
    ++wins[std::ranges::min_element(rows, {}, ns_of)->clipper];
  }
  std::vector<std::pair<int, std::string>> order;
  for (const auto& [clipper, count] : wins) order.emplace_back(-count, clipper);
  std::ranges::sort(order);
  std::vector<std::string> parts;
  for (const auto& [count, clipper] : order) {
    parts.push_back(fmt::format("{} on {}", clipper, -count));
  }
  return fmt::format("Fastest in {}, of {} mixes: {}.", scalar, mixes.size(),
                     fmt::join(parts, ", "));
}

// Who is wrong if that is few, else how far off they are.
std::string wrong_text(const std::vector<TimeRow>& times, const std::string& scalar) {
  const std::vector<TimeRow> rows = rows_where(times, &TimeRow::scalar, scalar);
  std::map<std::string, std::int64_t> wrong;  // by clipper
  for (const TimeRow& row : rows) {
    if (row.wrong > 0) wrong[row.clipper] += row.wrong;
  }
  constexpr std::size_t kFew = 2;
  if (wrong.size() > kFew) {
    const TimeRow& worst = *std::ranges::max_element(rows, {}, &TimeRow::max_px);
    return fmt::format("In {} errors reach {:.3g} px ({} on {}).", scalar, worst.max_px,
                       worst.clipper, worst.mix);
  }
  std::vector<std::string> names;
  for (const auto& [clipper, count] : wrong) {
    names.push_back(fmt::format("{} with {} segments", clipper, count));
  }
  return fmt::format("Wrong in {}: {} of {} clippers{}.", scalar, wrong.size(),
                     distinct(rows, &TimeRow::clipper).size(),
                     names.empty() ? "" : fmt::format(" ({})", fmt::join(names, ", ")));
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

std::string finding(const std::vector<TimeRow>& times, const std::vector<OperationsRow>& operations,
                    const std::vector<IntersectionRow>& intersections) {
  using R = OperationsRow;
  const auto figure = [&](const char* mix, const char* clipper, R::Figure R::*member) {
    const R* row = find_row(operations, &R::mix, mix, &R::clipper, clipper);
    return row == nullptr ? std::nullopt : row->*member;
  };
  std::vector<std::string> sentences;
  const auto small = figure("window_1_64", kCohenSutherland, &R::rejected_free_percent);
  const auto lines = figure("long_lines", kCohenSutherland, &R::rejected_free_percent);
  if (small && lines) {
    sentences.push_back(fmt::format(
        "With a window of 1/64 of the drawing Cohen-Sutherland rejects {:.1f} % of the invisible lines without an intersection, of lines right across the drawing {:.1f} %.",
        *small, *lines));
  }
  const auto repeated = figure("cross_several", kCohenSutherland, &R::divisions_per_shortened);
  const auto moved = figure("cross_several", kCohenSutherland, &R::moved_ends_per_shortened);
  const auto published = figure("inside", kPublished, &R::divisions_per_accepted);
  const auto products = figure("inside", kProducts, &R::divisions_per_accepted);
  const auto once = figure("cross_several", kProducts, &R::divisions_per_shortened);
  if (repeated && moved && published && products && once) {
    sentences.push_back(fmt::format(
        "Where several planes cut it computes {:.2f} intersections to move {:.2f} ends, Liang-Barsky by products {:.2f}; to accept, that divides {:.0f} times, Liang-Barsky as published {:.0f} times.",
        *repeated, *moved, *once, *products, *published));
  }
  if (intersections.size() > 4) {
    const OperationCounts &any = intersections[0].cut, &oblique = intersections[4].cut;
    sentences.push_back(fmt::format(
        "An intersection takes {} multiplications and {} division with any plane, {} and {} in clip space, oblique or not.",
        any.multiplications, any.divisions, oblique.multiplications, oblique.divisions));
  }
  if (!times.empty()) sentences.push_back(fastest_text(times, times.front().scalar));
  for (const std::string& scalar : distinct(times, &TimeRow::scalar)) {
    sentences.push_back(wrong_text(times, scalar));
  }
  return fmt::format("{}", fmt::join(sentences, " "));
}

}  // namespace clipscope::experiments::segments

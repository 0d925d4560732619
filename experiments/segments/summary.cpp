// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/segments/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/report/row_view.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::string_view kCohenSutherland = "homogeneous/cohen_sutherland";
constexpr std::string_view kPublished = "homogeneous/liang_barsky";
constexpr std::string_view kProducts = "homogeneous/liang_barsky_division_free";

// Bars of more clippers than this can't be told apart: then these are shown.
constexpr std::size_t kMostSeries = 6;
constexpr std::array<std::string_view, kMostSeries> kShown = {kCohenSutherland,
                                                              kPublished,
                                                              kProducts,
                                                              "view/cyrus_beck",
                                                              "cvv/cohen_sutherland",
                                                              "window/nicholl_lee_nicholl"};

// Of the row of a mix and a clipper.
std::optional<double> figure(const Table& table, std::string_view mix, std::string_view clipper,
                             std::string_view key) {
  for (const RowView& row : rows_of(table)) {
    if (row.text("mix") == mix && row.text("clipper") == clipper) return row.find_number(key);
  }
  return std::nullopt;
}

void add_once(std::vector<std::string>& names, const std::string& name) {
  if (std::ranges::find(names, name) == names.end()) names.push_back(name);
}

// Bars by mix, a set for each clipper; `belongs` chooses rows.
template <class Belongs>
std::optional<Plot> bars_by_mix(Plot plot, const Table& table, std::string_view key,
                                Belongs&& belongs) {
  std::vector<std::string> clippers;
  for (const RowView& row : rows_of(table)) {
    if (!belongs(row)) continue;
    add_once(plot.categories, row.text("mix"));
    add_once(clippers, row.text("clipper"));
  }
  if (clippers.empty()) return std::nullopt;
  if (clippers.size() > kMostSeries) clippers.assign(kShown.begin(), kShown.end());
  for (const std::string& clipper : clippers) {
    Series series;
    series.name = clipper;
    series.y.assign(plot.categories.size(), std::numeric_limits<double>::quiet_NaN());
    for (const RowView& row : rows_of(table)) {
      if (!belongs(row) || row.text("clipper") != clipper) continue;
      const auto mix = std::ranges::find(plot.categories, row.text("mix"));
      series.y[static_cast<std::size_t>(mix - plot.categories.begin())] =
          row.find_number(key).value_or(std::numeric_limits<double>::quiet_NaN());
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

// "homogeneous/cohen_sutherland on 5 of 9 mixes, ...", by how often a clipper is the fastest, in `scalar`.
std::string fastest_text(const Table& times, const std::string& scalar) {
  std::map<std::string, std::pair<double, std::string>> best;  // by mix
  for (const RowView& row : rows_of(times)) {
    const auto ns = row.find_number("ns_per_segment");
    if (!ns || row.text("scalar") != scalar) continue;
    const auto [at, is_first] = best.try_emplace(row.text("mix"), *ns, row.text("clipper"));
    if (!is_first && *ns < at->second.first) at->second = {*ns, row.text("clipper")};
  }
  std::map<std::string, int> wins;
  for (const auto& [mix, winner] : best) ++wins[winner.second];
  std::vector<std::pair<int, std::string>> order;
  for (const auto& [clipper, count] : wins) order.emplace_back(-count, clipper);
  std::ranges::sort(order);
  std::string result;
  for (const auto& [count, clipper] : order) {
    result += fmt::format("{}{} on {}", result.empty() ? "" : ", ", clipper, -count);
  }
  return fmt::format("Fastest in {}, of {} mixes: {}.", scalar, best.size(), result);
}

// In each scalar: who is wrong if that is few, else how far off they are.
std::string wrong_text(const Table& times, const std::string& scalar) {
  std::map<std::string, double> wrong;  // by clipper
  double max_px = 0;
  std::string worst;
  for (const RowView& row : rows_of(times)) {
    if (row.text("scalar") != scalar) continue;
    wrong[row.text("clipper")] += row.find_number("wrong").value_or(0);
    const double px = row.find_number("max_px").value_or(0);
    if (px <= max_px) continue;
    max_px = px;
    worst = fmt::format("{} on {}", row.text("clipper"), row.text("mix"));
  }
  const std::size_t clippers = wrong.size();
  std::erase_if(wrong, [](const auto& entry) { return entry.second == 0; });
  constexpr std::size_t kFew = 2;
  if (wrong.size() > kFew) {
    return fmt::format(" In {} errors reach {:.3g} px ({}).", scalar, max_px, worst);
  }
  std::string names;
  for (const auto& [clipper, count] : wrong) {
    names += fmt::format("{}{} with {:.0f} segments", names.empty() ? "" : ", ", clipper, count);
  }
  return fmt::format(" Wrong in {}: {} of {} clippers{}.", scalar, wrong.size(), clippers,
                     names.empty() ? "" : " (" + names + ")");
}

std::string separator(const std::string& sentences) { return sentences.empty() ? "" : " "; }

}  // namespace

std::optional<Plot> time_plot(const Table& times) {
  if (times.rows().empty()) return std::nullopt;
  const std::string scalar = rows_of(times).front().text("scalar");
  return bars_by_mix({.name = "segments",
                      .title = fmt::format("Time per segment by mix ({})", scalar),
                      .caption = "View space in, NDC out, with four attributes.",
                      .x = {},
                      .y = {.label = "time [ns/segment]", .from = 0},
                      .series = {}},
                     times, "ns_per_segment", [&](const RowView& row) {
                       return row.text("scalar") == scalar &&
                              row.find_number("ns_per_segment").has_value();
                     });
}

std::optional<Plot> divisions_plot(const Table& operations) {
  return bars_by_mix(
      {.name = "segments_divisions",
       .title = "Divisions that cut, per segment by mix",
       .caption = "All divisions but the four per vertex of the perspective divide: one for each "
                  "parameter of an intersection, after the divide one more for the attributes of "
                  "a new end.",
       .x = {},
       .y = {.label = "divisions per segment", .from = 0},
       .series = {}},
      operations, "cut_divisions", [](const RowView&) { return true; });
}

std::string segments_finding(const Table& times, const Table& operations,
                             const Table& intersections) {
  std::string finding;
  const auto small = figure(operations, "window_1_64", kCohenSutherland, "rejected_free_percent");
  const auto lines = figure(operations, "long_lines", kCohenSutherland, "rejected_free_percent");
  if (small && lines) {
    finding += fmt::format(
        "With a window of 1/64 of the drawing Cohen-Sutherland rejects {:.1f} % of the invisible "
        "lines without an intersection, of lines right across the drawing {:.1f} %.",
        *small, *lines);
  }
  const auto repeated =
      figure(operations, "cross_several", kCohenSutherland, "divisions_per_shortened");
  const auto moved =
      figure(operations, "cross_several", kCohenSutherland, "moved_ends_per_shortened");
  const auto published = figure(operations, "inside", kPublished, "divisions_per_accepted");
  const auto products = figure(operations, "inside", kProducts, "divisions_per_accepted");
  const auto once = figure(operations, "cross_several", kProducts, "divisions_per_shortened");
  if (repeated && moved && published && products && once) {
    finding += fmt::format(
        "{}Where several planes cut it computes {:.2f} intersections to move {:.2f} ends, "
        "Liang-Barsky by products {:.2f}; to accept, that divides {:.0f} times, Liang-Barsky as "
        "published {:.0f} times.",
        separator(finding), *repeated, *moved, *once, *products, *published);
  }
  if (intersections.rows().size() > 4) {
    const RowView any(intersections, 0), oblique(intersections, 4);
    finding += fmt::format(
        "{}An intersection takes {:.0f} multiplications and {:.0f} division with any plane, {:.0f} "
        "and {:.0f} in clip space, oblique or not.",
        separator(finding), any.find_number("multiplications").value_or(0),
        any.find_number("divisions").value_or(0),
        oblique.find_number("multiplications").value_or(0),
        oblique.find_number("divisions").value_or(0));
  }
  if (!times.rows().empty()) {
    finding += separator(finding) + fastest_text(times, rows_of(times).front().text("scalar"));
    std::vector<std::string> scalars;
    for (const RowView& row : rows_of(times)) {
      add_once(scalars, row.text("scalar"));
    }
    for (const std::string& scalar : scalars) finding += wrong_text(times, scalar);
  }
  return finding;
}

}  // namespace clipscope::experiments

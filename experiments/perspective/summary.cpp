// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/perspective/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "experiments/report/row_view.hpp"

namespace clipscope::experiments {
namespace {

constexpr double kSmallest = 1e-4, kLargest = 1e4;  // of w_max / w_min - 1

Series ratio_series(const Table& ratios, std::string name, std::string_view key, Marks marks) {
  Series series{.name = std::move(name), .x = {}, .y = {}, .marks = marks};
  for (const RowView& row : rows_of(ratios)) {
    series.x.push_back(row.number("w_ratio") - 1);
    series.y.push_back(row.number(key));
  }
  return series;
}

// The errors of one clipper's new vertices.
Series clip_series(const Table& clip, const std::string& clipper, const std::string& scalar) {
  Series series{
      .name = fmt::format("{}, {}", clipper, scalar), .x = {}, .y = {}, .marks = Marks::points};
  for (const RowView& row : rows_of(clip)) {
    if (row.text("clipper") != clipper || row.text("scalar") != scalar) continue;
    series.x.push_back(row.number("w_ratio") - 1);
    series.y.push_back(row.number("max_error"));
  }
  return series;
}

// One horizontal line for each different error.
std::vector<Series> threshold_lines(const Table& thresholds) {
  std::vector<Series> lines;
  std::set<double> drawn;
  for (const RowView& row : rows_of(thresholds)) {
    const double error = row.number("error");
    if (!drawn.insert(error).second) continue;
    const bool ramp = row.text("criterion").ends_with("ramp");
    lines.push_back({.name = "",
                     .x = {kSmallest, kLargest},
                     .y = {error, error},
                     .labels = {"", ramp ? row.text("criterion")
                                         : fmt::format("{}, {} texels", row.text("criterion"),
                                                       row.count("texture_texels"))},
                     .marks = Marks::line,
                     .muted = true});
  }
  return lines;
}

// "1.0078 (256 texels), ...": the ratios of a criterion.
std::string ratios_of(const Table& thresholds, std::string_view criterion) {
  std::string list;
  for (const RowView& row : rows_of(thresholds)) {
    if (row.text("criterion") != criterion) continue;
    list += fmt::format("{}{:.5g} ({} texels)", list.empty() ? "" : ", ", row.number("w_ratio"),
                        row.count("texture_texels"));
  }
  return list;
}

// The scenes that need it most and least.
std::string scenes_sentence(const Table& scenes) {
  const auto rows = rows_of(scenes);
  if (rows.empty()) return "";
  const auto need = [](const RowView& row) { return row.number("above_1024_percent"); };
  const auto [least, most] = std::ranges::minmax_element(rows, {}, need);
  if (least == most) {
    return fmt::format(
        " With 1024 texels per unit {:.3g} % of the visible triangles of {} are off by more.",
        need(*most), most->text("scene"));
  }
  return fmt::format(
      " With 1024 texels per unit {:.3g} % of the visible triangles of {} are off by more, and "
      "{:.3g} % "
      "of {}.",
      need(*most), most->text("scene"), need(*least), least->text("scene"));
}

// The largest error of a clipper's new vertices.
double largest_error(const Table& clip, std::string_view clipper) {
  double largest = -1;
  for (const RowView& row : rows_of(clip)) {
    if (row.text("clipper") == clipper) largest = std::max(largest, row.number("max_error"));
  }
  return largest;
}

std::string clip_sentence(const Table& clip) {
  const double naive = largest_error(clip, "cvv/naive");
  const double perspective = largest_error(clip, "cvv/perspective");
  if (naive < 0 || perspective < 0) return "";
  return fmt::format(
      " Cutting after the divide carries the same error into new vertices unless it is corrected: "
      "up to {:.3g} against {:.2g}.",
      naive, perspective);
}

}  // namespace

Plot error_over_ratio(const PerspectiveTables& tables) {
  Plot plot{
      .name = "perspective",
      .title = "Largest error without perspective correction",
      .caption =
          "Share of an attribute's range by which affine interpolation is off, over the ratio of w "
          "in "
          "the triangle. The curve is the bound, the marks what was measured; grey lines are "
          "errors "
          "that can just be seen in a texture laid once along the edge.",
      .x = {.label = "w_max / w_min - 1", .logarithmic = true, .from = kSmallest, .to = kLargest},
      .y = {.label = "error [share of the range]", .logarithmic = true, .from = 1e-7, .to = 1},
      .series = threshold_lines(tables.thresholds)};
  plot.series.push_back(
      ratio_series(tables.ratios, "bound (sqrt(r) - 1) / (sqrt(r) + 1)", "bound", Marks::line));
  plot.series.push_back(
      ratio_series(tables.ratios, "measured on the edge", "measured_max", Marks::points));
  plot.series.push_back(
      ratio_series(tables.ratios, "measured inside triangles", "inside_max", Marks::points));
  for (const char* clipper : {"cvv/naive", "cvv/perspective"}) {
    Series series = clip_series(tables.clip, clipper, "float");
    if (!series.x.empty()) plot.series.push_back(std::move(series));
  }
  return plot;
}

std::string perspective_finding(const PerspectiveTables& tables) {
  std::int64_t beyond = 0, attained = 0;
  const auto rows = rows_of(tables.ratios);
  for (const RowView& row : rows) {
    beyond += row.count("beyond");
    attained += row.text("attained") == "yes";
  }
  return fmt::format(
             "Without perspective correction an attribute is off by up to (sqrt(r) - 1) / (sqrt(r) "
             "+ 1) of "
             "its range, r = w_max/w_min: attained exactly at {} of {} ratios, passed at {} "
             "points. Half a "
             "texel is passed at r = {}.",
             attained, rows.size(), beyond, ratios_of(tables.thresholds, "half a texel")) +
         scenes_sentence(tables.scenes) + clip_sentence(tables.clip);
}

}  // namespace clipscope::experiments

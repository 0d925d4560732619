// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/perspective/rows.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/contestants/spoken.hpp"
#include "experiments/table/prose.hpp"

namespace clipscope::experiments::perspective {
namespace {

constexpr double kSmallest = 1e-4, kLargest = 1e4;  // of w_max / w_min - 1

template <class Row>
Series series_of(std::string name, Marks marks, const std::vector<Row>& rows, double Row::*error) {
  Series series{.name = std::move(name), .marks = marks};
  for (const Row& row : rows) series.add(row.ratio - 1, row.*error);
  return series;
}

// One horizontal line for each different error.
std::vector<Series> threshold_lines(const std::vector<ThresholdRow>& thresholds) {
  std::vector<Series> lines;
  for (const double error : distinct(thresholds, &ThresholdRow::error)) {
    const ThresholdRow& row = *find_row(thresholds, &ThresholdRow::error, error);
    std::string label = row.criterion;
    if (!label.ends_with("ramp")) label += fmt::format(", {} texels", row.texels);
    lines.push_back({.name = "",
                     .x = {kSmallest, kLargest},
                     .y = {error, error},
                     .labels = {"", label},
                     .marks = Marks::line,
                     .muted = true});
  }
  return lines;
}

std::string bound_sentence(const std::vector<RatioRow>& ratios) {
  if (ratios.empty()) return "No error without perspective correction was measured.";
  std::int64_t beyond = 0;
  for (const RatioRow& row : ratios) beyond += row.beyond;
  const auto attained = std::ranges::count(ratios, true, &RatioRow::attained);
  const double share = static_cast<double>(attained) / static_cast<double>(ratios.size());
  return fmt::format(
      "The bound of the error without perspective correction {}: it is attained exactly at {} ratios of w that were tried, and passed {}.",
      beyond > 0   ? "does not hold"
      : share == 1 ? "is sharp"
                   : "holds",
      quantity(share), beyond == 0 ? "nowhere" : "at some points");
}

// From which ratio on it can be seen, with 1024 texels if that was asked for.
std::string threshold_sentence(const std::vector<ThresholdRow>& thresholds) {
  using R = ThresholdRow;
  const R* row = find_row(thresholds, &R::criterion, "half a texel", &R::texels, 1024);
  if (row == nullptr) row = find_row(thresholds, &R::criterion, "half a texel");
  if (row == nullptr) return "";
  return fmt::format(
      " In a texture of {} texels it reaches half a texel as soon as w varies by a factor of {:.5g} along an edge.",
      row->texels, row->ratio);
}

// The scenes that need it most and least.
std::string scenes_sentence(const std::vector<SceneRow>& scenes) {
  if (scenes.empty()) return "";
  const auto need = [](const SceneRow& row) { return row.above_1024; };
  const auto [least, most] = std::ranges::minmax_element(scenes, {}, need);
  std::string text = fmt::format(" With such a texture {} visible parts call for correction on {}",
                                 quantity(need(*most) / 100), spoken_set(most->scene));
  if (least != most) {
    text += fmt::format(", and {} on {}", quantity(need(*least) / 100), spoken_set(least->scene));
  }
  return text + ".";
}

std::string cut_sentence(const std::vector<CutRow>& cuts) {
  const auto largest = [&](std::string_view clipper) {
    double error = -1;
    for (const CutRow& row : rows_where(cuts, &CutRow::clipper, clipper)) {
      error = std::max(error, row.max_error);
    }
    return error;
  };
  const double naive = largest("cvv/naive"), perspective = largest("cvv/perspective");
  if (naive < 0 || perspective < 0) return "";
  return naive > 10 * perspective
             ? " A cut after the divide carries the same error into new vertices unless it corrects for it."
             : " A cut after the divide adds no such error to new vertices, corrected or not.";
}

}  // namespace

Plot error_plot(const Tables& tables) {
  Plot plot{
      .name = "perspective",
      .title = "Largest error without perspective correction",
      .caption =
          "Share of an attribute's range by which affine interpolation is off, over the ratio of w in the triangle. The curve is the bound, the marks what was measured; grey lines are errors that can just be seen in a texture laid once along the edge.",
      .x = {.label = "w_max / w_min - 1", .logarithmic = true, .from = kSmallest, .to = kLargest},
      .y = {.label = "error [share of the range]", .logarithmic = true, .from = 1e-7, .to = 1},
      .series = threshold_lines(tables.thresholds.rows())};
  const std::vector<RatioRow> ratios = tables.ratios.rows();
  const auto add = [&](const char* name, Marks marks, double RatioRow::*error) {
    plot.series.push_back(series_of(name, marks, ratios, error));
  };
  add("bound (sqrt(r) - 1) / (sqrt(r) + 1)", Marks::line, &RatioRow::bound);
  add("measured on the edge", Marks::points, &RatioRow::on_edges);
  add("measured inside triangles", Marks::points, &RatioRow::inside);
  for (const std::string clipper : {"cvv/naive", "cvv/perspective"}) {
    const auto rows =
        rows_where(tables.cuts.rows(), &CutRow::clipper, clipper, &CutRow::scalar, "float");
    if (rows.empty()) continue;
    plot.series.push_back(series_of(clipper + ", float", Marks::points, rows, &CutRow::max_error));
  }
  return plot;
}

std::string finding(const Tables& tables) {
  return bound_sentence(tables.ratios.rows()) + threshold_sentence(tables.thresholds.rows()) +
         scenes_sentence(tables.scenes.rows()) + cut_sentence(tables.cuts.rows());
}

}  // namespace clipscope::experiments::perspective

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "experiments/w_sign/rows.hpp"

namespace clipscope::experiments::w_sign {
namespace {

constexpr std::string_view kPlain = "homogeneous/sutherland_hodgman";

std::string patterns_text(const std::vector<PatternRow>& patterns) {
  std::int64_t plain = 0, naive = 0, triangles = 0;
  for (const PatternRow& row : rows_where(patterns, &PatternRow::scalar, "float")) {
    if (row.clipper == kPlain) {
      plain += row.failures;
      triangles += row.triangles;
    }
    if (row.clipper == "cvv/naive") naive += row.failures;
  }
  if (triangles == 0) return "";
  return fmt::format(
      "of {} random triangles with every sign of w float clip space fails on {}, clipping after the divide on {}; ",
      triangles, plain, naive);
}

}  // namespace

Plot loss_plot(const std::vector<EpsilonRow>& epsilon) {
  Plot plot{
      .name = "w_sign_epsilon",
      .title = "What a plane w >= epsilon cuts away of a wall past the eye",
      .caption =
          "The part of the visible area that is lost, by the scale of the scene. A scene in metres loses nothing; the smaller its lengths, the more of it lies nearer than epsilon.",
      .x = {.label = "scale of the scene [m]", .logarithmic = true},
      .y = {.label = "visible area lost [%]", .from = 0.0, .to = 105.0}};
  const auto walls = rows_where(epsilon, &EpsilonRow::surface, "wall");
  for (const std::string& depth : distinct(walls, &EpsilonRow::depth)) {
    for (const std::optional<double>& plane : distinct(walls, &EpsilonRow::epsilon)) {
      if (!plane) continue;
      Series series{.name = fmt::format("w >= {:.2g}, {}", *plane, depth)};
      for (const EpsilonRow& row :
           rows_where(walls, &EpsilonRow::depth, depth, &EpsilonRow::epsilon, plane)) {
        series.add(row.scale_m, row.loss.lost_percent);
      }
      if (std::ranges::max(series.y) >= 0.01) plot.series.push_back(std::move(series));
    }
  }
  return plot;
}

std::string finding(const std::vector<PatternRow>& patterns, const std::vector<EpsilonRow>& epsilon,
                    const std::vector<PreventedRow>& prevented) {
  std::int64_t in_patterns = 0, in_scenes = 0, clipped_in_scenes = 0;
  for (const PreventedRow& row : rows_where(prevented, &PreventedRow::clipper, kPlain)) {
    const bool is_scene = row.input != "patterns";
    (is_scene ? in_scenes : in_patterns) += row.hazards.total();
    if (is_scene) clipped_in_scenes += row.hazards.triangles;
  }
  std::string text = patterns_text(patterns);
  text += fmt::format(
      "without a w-plane {} of {} triangles of scenes, with and without a near plane, leave a division by 0, by a negative w or an overflow, and {} of the random ones",
      in_scenes, clipped_in_scenes, in_patterns);
  std::set<std::string> told;
  for (const EpsilonRow& row : epsilon) {
    if (row.loss.lost_percent < 1 || !told.insert(row.clipper).second) continue;
    text += fmt::format("; {} loses {:.0f} % of a visible {} in a scene of {:g} m ({})",
                        row.clipper, row.loss.lost_percent, row.surface, row.scale_m, row.depth);
  }
  return text + ".";
}

}  // namespace clipscope::experiments::w_sign

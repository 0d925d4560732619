// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "experiments/table/prose.hpp"
#include "experiments/w_sign/rows.hpp"

namespace clipscope::experiments::w_sign {
namespace {

constexpr std::string_view kPlain = "homogeneous/sutherland_hodgman", kNaive = "cvv/naive";

// What leaves a division by 0 and the like without a w-plane.
std::string scenes_sentence(const std::vector<PreventedRow>& prevented) {
  std::int64_t hazards = 0, clipped = 0;
  for (const PreventedRow& row : rows_where(prevented, &PreventedRow::clipper, kPlain)) {
    if (row.input == "patterns") continue;
    hazards += row.hazards.total();
    clipped += row.hazards.triangles;
  }
  if (clipped == 0) return "No scene was clipped in clip space by the six planes alone.";
  constexpr std::string_view kWhat = "a division by zero, by a negative w or an overflow";
  if (hazards == 0) {
    return fmt::format(
        "Scenes need no plane in front of the six in clip space: none of {} clipped triangles leaves {}.",
        clipped, kWhat);
  }
  return fmt::format(
      "Scenes need a plane in front of the six in clip space: {} clipped triangles leave {}.",
      hazards, kWhat);
}

// What a plane w >= epsilon costs.
std::string loss_sentence(const std::vector<EpsilonRow>& epsilon) {
  double worst = 0;
  for (const EpsilonRow& row : epsilon) {
    if (row.epsilon && *row.epsilon > 0) worst = std::max(worst, row.loss.lost_percent);
  }
  if (epsilon.empty()) return "";
  if (worst < 1) return " A plane w >= epsilon cut away nothing visible at any scale.";
  return fmt::format(
      " A plane w >= epsilon cuts away {} of what is visible where lengths come near epsilon.",
      worst >= 50 ? "most" : "some");
}

// Clip space and dividing first on random triangles.
std::string patterns_sentence(const std::vector<PatternRow>& patterns) {
  std::int64_t plain = 0, naive = 0, triangles = 0;
  for (const PatternRow& row : rows_where(patterns, &PatternRow::scalar, "float")) {
    if (row.clipper == kPlain) {
      plain += row.failures;
      triangles += row.triangles;
    }
    if (row.clipper == kNaive) naive += row.failures;
  }
  if (triangles == 0 || find_row(patterns, &PatternRow::clipper, kNaive) == nullptr) return "";
  const std::string often =
      naive > plain && plain > 0
          ? fmt::format("{} as often as",
                        times_text(static_cast<double>(naive) / static_cast<double>(plain)))
      : naive > plain  ? "more often than"
      : naive == plain ? "as often as"
                       : "less often than";
  return fmt::format(
      " On random triangles with every sign of w dividing first is wrong {} clip space in float.",
      often);
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
  return scenes_sentence(prevented) + loss_sentence(epsilon) + patterns_sentence(patterns);
}

}  // namespace clipscope::experiments::w_sign

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "experiments/depth/rows.hpp"

namespace clipscope::experiments::depth {
namespace {

constexpr double kRatio = 1e5;  // far over near, of which the finding speaks

// The share of neighbours that a float pipeline does not order in a buffer.
std::optional<double> lost_percent(const std::vector<PrecisionRow>& precision,
                                   std::string_view convention, Stored buffer) {
  using R = PrecisionRow;
  const R* row = find_row(precision, &R::convention, convention, &R::buffer, buffer, &R::transform,
                          Arithmetic::in_float, &R::far_near_ratio, kRatio);
  return row == nullptr ? std::nullopt : std::optional(row->lost_percent());
}

std::string float_sentence(const std::vector<PrecisionRow>& precision) {
  const auto reversed = lost_percent(precision, "reversed", Stored::float32);
  const auto forward = lost_percent(precision, "zero_to_one", Stored::float32);
  const auto gl = lost_percent(precision, "gl", Stored::float32);
  if (!reversed || !forward || !gl) return "";
  return fmt::format(
      "In a float buffer reversed depth {}: where far over near is a hundred thousand, a float pipeline fails to order {} % of neighbours with it, and up to {} % with the other conventions.",
      *reversed < std::min(*forward, *gl) ? "is the most precise" : "is no more precise",
      format_number(*reversed), format_number(std::max(*forward, *gl)));
}

std::string fixed_sentence(const std::vector<PrecisionRow>& precision) {
  const auto reversed = lost_percent(precision, "reversed", Stored::unorm24);
  const auto forward = lost_percent(precision, "zero_to_one", Stored::unorm24);
  if (!reversed || !forward) return "";
  constexpr double kAlike = 1.1;
  const std::string_view what = *forward > kAlike * *reversed   ? "helps, too"
                                : *reversed > kAlike * *forward ? "harms"
                                                                : "changes little";
  return fmt::format("In 24-bit fixed point reversing {}.", what);
}

std::string form_sentence(const std::vector<FormRow>& forms) {
  const auto bends = [&](Form form) -> std::optional<bool> {
    const FormRow* row =
        find_row(forms, &FormRow::form, form, &FormRow::property, "lines stay straight");
    return row == nullptr ? std::nullopt : std::optional(row->max_deviation_ndc > 0);
  };
  const auto quadratic = bends(Form::quadratic), linear = bends(Form::linear);
  if (!quadratic) return "";
  std::string text = fmt::format("A depth that is linear in distance {} straight edges",
                                 *quadratic ? "bends" : "does not bend");
  if (linear) text += fmt::format("; the hyperbolic one {}", *linear ? "bends them" : "does not");
  return text + ".";
}

}  // namespace

Plot curve_plot(const std::vector<CurveRow>& curve) {
  Plot plot{
      .name = "depth_resolution",
      .title = "What a depth buffer tells apart",
      .caption =
          "The smallest separation told apart, by distance. With a float buffer reversed depth keeps the relative precision of floats; the others lose it as distance squared.",
      .x = {.label = "distance [m]", .logarithmic = true},
      .y = {.label = "smallest separation told apart [m]", .logarithmic = true}};
  for (const CurveRow& row : curve) {
    if (row.convention.ends_with("_infinite")) continue;
    const std::string name = fmt::format("{}, {}", row.convention, name_of(row.buffer));
    if (plot.series.empty() || plot.series.back().name != name) plot.series.push_back({name});
    plot.series.back().add(row.distance_m, row.resolution_m);
  }
  return plot;
}

Plot lost_order_plot(const std::vector<PrecisionRow>& precision) {
  Plot plot{
      .name = "depth_lost_order",
      .title = "Neighbours that depth does not put in order",
      .caption =
          "Share of neighbouring distances (10,000, logarithmically spread) that come out equal or in the wrong order, transform in float.",
      .x = {.label = "far / near", .logarithmic = true},
      .y = {.label = "misordered or tied [%]", .from = 0.0}};
  for (const std::string& convention : distinct(precision, &PrecisionRow::convention)) {
    if (convention.ends_with("_infinite")) continue;
    for (const Stored format : {Stored::unorm24, Stored::float32}) {
      Series series{.name = fmt::format("{}, {}", convention, name_of(format))};
      for (const PrecisionRow& row :
           rows_where(precision, &PrecisionRow::convention, convention, &PrecisionRow::buffer,
                      format, &PrecisionRow::transform, Arithmetic::in_float)) {
        series.add(row.far_near_ratio, row.lost_percent());
      }
      plot.series.push_back(std::move(series));
    }
  }
  return plot;
}

std::string finding(const std::vector<PrecisionRow>& precision, const std::vector<FormRow>& forms) {
  std::vector<std::string> sentences = {float_sentence(precision), fixed_sentence(precision),
                                        form_sentence(forms)};
  std::erase(sentences, "");
  if (sentences.empty()) return "No depth was measured.";
  return fmt::format("{}", fmt::join(sentences, " "));
}

}  // namespace clipscope::experiments::depth

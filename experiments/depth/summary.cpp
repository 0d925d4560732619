// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "experiments/depth/rows.hpp"

namespace clipscope::experiments::depth {

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
  std::vector<std::string> lost;
  for (const auto& [convention, format] :
       {std::pair{"reversed", Stored::float32}, std::pair{"zero_to_one", Stored::float32},
        std::pair{"gl", Stored::float32}, std::pair{"zero_to_one", Stored::unorm24},
        std::pair{"reversed", Stored::unorm24}}) {
    const PrecisionRow* row = find_row(precision, &PrecisionRow::convention, convention,
                                       &PrecisionRow::buffer, format, &PrecisionRow::transform,
                                       Arithmetic::in_float, &PrecisionRow::far_near_ratio, 1e5);
    if (row != nullptr) lost.push_back(format_number(row->lost_percent()));
  }
  std::string text;
  if (lost.size() == 5) {
    text = fmt::format(
        "At far/near = 1e5 a float pipeline with a float buffer fails to order {} % of neighbours with reversed depth, {} % with [0, 1] and {} % with [-1, 1]; in 24-bit fixed point reversing changes {} % to {} %. ",
        lost[0], lost[1], lost[2], lost[3], lost[4]);
  }
  const FormRow* bent =
      find_row(forms, &FormRow::form, Form::quadratic, &FormRow::property, "lines stay straight");
  if (bent == nullptr) return text;
  return text +
         fmt::format(
             "A depth linear in distance bends straight edges by up to {} of its range of 2 (far/near = {:g}); the hyperbolic one by exactly 0.",
             format_number(bent->max_deviation_ndc), bent->far_near_ratio);
}

}  // namespace clipscope::experiments::depth

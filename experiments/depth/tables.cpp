// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/depth/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/errors.hpp"
#include "experiments/hex_float.hpp"
#include "experiments/report/row_view.hpp"

namespace clipscope::experiments {
namespace {

Cell metres(const std::optional<double>& value) {
  if (value) return *value;
  return {};
}

double percent(std::size_t part, std::size_t whole) {
  return 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

std::string arithmetic_name(DepthArithmetic arithmetic) {
  return arithmetic == DepthArithmetic::in_float ? "float" : "double";
}

// Whether a row is that of a convention and a buffer, transform in float.
bool is_of(const RowView& row, std::string_view convention, std::string_view format) {
  return row.text("convention") == convention && row.text("buffer") == format &&
         row.text("transform") == "float";
}

double lost_percent(const RowView& row) {
  return row.number("misordered_percent") + row.number("tied_percent");
}

// The share of neighbours not told apart in the right order; nothing if there is no such row.
std::optional<double> lost_order(const Table& precision, std::string_view convention,
                                 std::string_view format, double ratio) {
  for (const RowView& row : rows_of(precision)) {
    if (is_of(row, convention, format) && row.number("far_near_ratio") == ratio) {
      return lost_percent(row);
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<DepthArithmetic> depth_arithmetics(const Selection& selection) {
  std::vector<DepthArithmetic> chosen;
  for (const DepthArithmetic a : {DepthArithmetic::in_float, DepthArithmetic::in_double}) {
    if (std::ranges::find(selection.scalars, arithmetic_name(a)) != selection.scalars.end()) {
      chosen.push_back(a);
    }
  }
  if (chosen.empty()) throw UsageError("--scalar: experiment depth takes float and double");
  return chosen;
}

DepthMeasures measure_depth(const DepthBuffer& buffer, std::span<const float> distances,
                            std::size_t error_stride) {
  const auto middle = static_cast<float>(std::sqrt(double{buffer.near()} * buffer.far()));
  return {{resolution(buffer, buffer.near()), resolution(buffer, middle),
           resolution(buffer, buffer.far())},
          buffer.code(buffer.far()) - buffer.code(buffer.near()) + 1,
          distinct_values(buffer, distances),
          neighbour_order(buffer, distances),
          largest_error(buffer, distances, error_stride)};
}

Table depth_precision_table() {
  Table table("depth", "What depth buffers tell apart, near plane at 0.1 m",
              {{"convention", "convention"},
               {"buffer", "buffer"},
               {"transform", "transform"},
               {"far_near_ratio", "far/near"},
               {"resolution_near_m", "at near [m]"},
               {"resolution_mid_m", "mid [m]"},
               {"resolution_far_m", "far [m]"},
               {"codes", "codes"},
               {"distinct_values", "distinct"},
               {"misordered_percent", "misordered [%]"},
               {"tied_percent", "tied [%]"},
               {"max_error_ulp", "max error [ulp]"}});
  table.add_note(
      "At near, mid, far: the smallest separation told apart there; mid is half way in logarithms; "
      "-: not even the near plane. Misordered, tied: of neighbours among 10,000 (quick: 2,000) "
      "random distances, logarithmically spread. Codes: numbers of the format between near and "
      "far; distinct: those that the distances got.");
  table.add_note(
      "Max error: of the stored depth against the exact rational, in ulp of float or steps of the "
      "fixed-point format. Infinite far planes are looked at up to the same far.");
  return table;
}

void add_depth_precision_row(Table& table, CellRecord& record, const DepthConvention& convention,
                             DepthFormat format, DepthArithmetic arithmetic, double ratio,
                             const DepthMeasures& m) {
  const std::string scalar = arithmetic_name(arithmetic);
  table.add_row({std::string(convention.name), std::string(format_name(format)), scalar, ratio,
                 metres(m.resolution_m[0]), metres(m.resolution_m[1]), metres(m.resolution_m[2]),
                 m.codes, static_cast<std::int64_t>(m.distinct),
                 percent(m.order.misordered, m.order.pairs), percent(m.order.tied, m.order.pairs),
                 m.error.ulp});
  record.worst_inputs.push_back(
      {fmt::format("{} {} far/near {:g}", convention.name, format_name(format), ratio), scalar,
       "depth_ulp", m.error.ulp, "0 0 " + hex_float(-m.error.distance), ""});
}

Table depth_curve_table(double ratio) {
  Table table("depth_resolution",
              fmt::format("Resolution over distance, far/near = {:g}, transform in float", ratio),
              {{"convention", "convention"},
               {"buffer", "buffer"},
               {"distance_m", "distance [m]"},
               {"resolution_m", "resolution [m]"}});
  table.add_note("Resolution: the smallest separation told apart, towards the eye.");
  return table;
}

Table depth_forms_table() {
  Table table("depth_monotone", "Depth z''/w with a linear and with a quadratic numerator",
              {{"form", "form"},
               {"property", "property"},
               {"arithmetic", "arithmetic"},
               {"far_near_ratio", "far/near"},
               {"samples", "samples"},
               {"violations", "violations"},
               {"max_deviation_ndc", "max dev. [NDC]"},
               {"max_deviation_m", "max dev. [m]"}});
  table.add_note(
      "Linear: z'' = ((f+n) d - 2fn) / (f-n); quadratic: z'' = (2d^2 - (f+n) d) / (f-n); d the "
      "distance, near at 1 m. Monotone: of neighbouring floats the farther has the larger depth "
      "(in "
      "float and double: not a smaller one). Lines stay straight: depth interpolated over the "
      "screen is the edge's depth. Nearer wins: of two edges in one pixel.");
  return table;
}

void add_form_rows(Table& table, double ratio, std::span<const DepthCheck> checks) {
  for (const DepthCheck& c : checks) {
    table.add_row({std::string(c.form), std::string(c.property), std::string(c.arithmetic), ratio,
                   static_cast<std::int64_t>(c.samples), static_cast<std::int64_t>(c.violations),
                   c.deviation_ndc, c.deviation_m});
  }
}

Table depth_eye_plane_table() {
  return Table("depth_eye_plane",
               "The point (1, 1, 0) in clip space: l = b = -1, r = t = 1, n = 1, f = 10",
               {{"arithmetic", "arithmetic"},
                {"x_clip", "x"},
                {"y_clip", "y"},
                {"z_clip", "z"},
                {"w_clip", "w"},
                {"divisible", "divisible"}});
}

void add_eye_plane_row(Table& table, const EyePlanePoint& p) {
  table.add_row({std::string(p.arithmetic), p.x, p.y, p.z, p.w, std::int64_t{p.finite_ndc}});
}

Plot depth_curve_plot(const Table& curve) {
  Plot plot{.name = "depth_resolution",
            .title = "What a depth buffer tells apart",
            .caption =
                "The smallest separation told apart, by distance. With a float buffer reversed "
                "depth keeps the relative precision of floats; the others lose it as "
                "distance squared.",
            .x = {.label = "distance [m]", .logarithmic = true},
            .y = {.label = "smallest separation told apart [m]", .logarithmic = true},
            .series = {}};
  for (const RowView& row : rows_of(curve)) {
    if (row.text("convention").ends_with("_infinite")) continue;
    const std::string name = row.text("convention") + ", " + row.text("buffer");
    if (plot.series.empty() || plot.series.back().name != name) {
      plot.series.push_back({.name = name, .x = {}, .y = {}});
    }
    plot.series.back().x.push_back(row.number("distance_m"));
    plot.series.back().y.push_back(row.number("resolution_m"));
  }
  return plot;
}

Plot depth_lost_order_plot(const Table& precision) {
  Plot plot{.name = "depth_lost_order",
            .title = "Neighbours that depth does not put in order",
            .caption =
                "Share of neighbouring distances (10,000, logarithmically spread) that come "
                "out equal or in the wrong order, transform in float.",
            .x = {.label = "far / near", .logarithmic = true},
            .y = {.label = "misordered or tied [%]", .from = 0.0},
            .series = {}};
  for (const DepthConvention& convention : kDepthConventions) {
    if (convention.infinite_far) continue;
    for (const std::string_view format : {"unorm24", "float32"}) {
      Series series{.name = fmt::format("{}, {}", convention.name, format), .x = {}, .y = {}};
      for (const RowView& row : rows_of(precision)) {
        if (!is_of(row, convention.name, format)) continue;
        series.x.push_back(row.number("far_near_ratio"));
        series.y.push_back(lost_percent(row));
      }
      plot.series.push_back(std::move(series));
    }
  }
  return plot;
}

std::string depth_finding(const Table& precision, const Table& forms) {
  constexpr double kRatioTold = 1e5;
  std::string finding;
  const auto reversed = lost_order(precision, "reversed", "float32", kRatioTold);
  const auto standard = lost_order(precision, "zero_to_one", "float32", kRatioTold);
  const auto gl = lost_order(precision, "gl", "float32", kRatioTold);
  const auto fixed = lost_order(precision, "reversed", "unorm24", kRatioTold);
  const auto fixed_standard = lost_order(precision, "zero_to_one", "unorm24", kRatioTold);
  if (reversed && standard && gl && fixed && fixed_standard) {
    finding = fmt::format(
        "At far/near = 1e5 a float pipeline with a float buffer fails to order {} % of neighbours "
        "with reversed depth, {} % with [0, 1] and {} % with [-1, 1]; in 24-bit fixed point "
        "reversing changes {} % to {} %. ",
        format_number(*reversed), format_number(*standard), format_number(*gl),
        format_number(*fixed_standard), format_number(*fixed));
  }
  for (const RowView& row : rows_of(forms)) {
    if (row.text("form") != "quadratic" || row.text("property") != "lines stay straight") continue;
    finding += fmt::format(
        "A depth linear in distance bends straight edges by up to {} of its range of 2 (far/near = "
        "{:g}); the hyperbolic one by exactly 0.",
        format_number(row.number("max_deviation_ndc")), row.number("far_near_ratio"));
    break;
  }
  return finding;
}

}  // namespace clipscope::experiments

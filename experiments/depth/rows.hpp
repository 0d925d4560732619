// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the tables about depth, and what is said of them at the end.
#pragma once

#include <cstdint>

#include "experiments/report/plot.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments::depth {

enum class Stored : std::uint8_t { unorm16, unorm24, float32 };
inline constexpr std::array kStored = {Stored::unorm16, Stored::unorm24, Stored::float32};
constexpr std::array<std::string_view, 3> names_of(Stored) {
  return {"unorm16", "unorm24", "float32"};
}

enum class Arithmetic : std::uint8_t { in_float, in_double };
constexpr std::array<std::string_view, 2> names_of(Arithmetic) { return {"float", "double"}; }

struct PrecisionRow {
  std::string convention;
  Stored buffer = Stored::float32;
  Arithmetic transform = Arithmetic::in_float;
  double far_near_ratio = 0;
  std::optional<double> resolution_near_m, resolution_mid_m, resolution_far_m;
  std::int64_t codes = 0;
  std::size_t distinct_values = 0;
  double misordered_percent = 0, tied_percent = 0, max_error_ulp = 0;

  double lost_percent() const { return misordered_percent + tied_percent; }

  static constexpr std::string_view kName = "depth";
  static constexpr std::string_view kTitle = "What depth buffers tell apart, near plane at 0.1 m";
  static constexpr std::array<std::string_view, 2> kNotes = {
      "At near, mid, far: the smallest separation told apart there; mid is half way in logarithms; -: not even the near plane. Misordered, tied: of neighbours among 10,000 (quick: 2,000) random distances, logarithmically spread. Codes: numbers of the format between near and far; distinct: those that the distances got.",
      "Max error: of the stored depth against the exact rational, in ulp of float or steps of the fixed-point format. Infinite far planes are looked at up to the same far."};
  static constexpr auto columns() {
    using R = PrecisionRow;
    return std::tuple(column("convention", &R::convention), column("buffer", &R::buffer),
                      column("transform", &R::transform),
                      column("far_near_ratio", "far/near", &R::far_near_ratio),
                      column("resolution_near_m", "at near [m]", &R::resolution_near_m),
                      column("resolution_mid_m", "mid [m]", &R::resolution_mid_m),
                      column("resolution_far_m", "far [m]", &R::resolution_far_m),
                      column("codes", &R::codes),
                      column("distinct_values", "distinct", &R::distinct_values),
                      column("misordered_percent", "misordered [%]", &R::misordered_percent),
                      column("tied_percent", "tied [%]", &R::tied_percent),
                      column("max_error_ulp", "max error [ulp]", &R::max_error_ulp));
  }
};

// The title names far/near.
struct CurveRow {
  std::string convention;
  Stored buffer = Stored::float32;
  double distance_m = 0, resolution_m = 0;

  static constexpr std::string_view kName = "depth_resolution";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Resolution: the smallest separation told apart, towards the eye."};
  static constexpr auto columns() {
    using R = CurveRow;
    return std::tuple(column("convention", &R::convention), column("buffer", &R::buffer),
                      column("distance_m", "distance [m]", &R::distance_m),
                      column("resolution_m", "resolution [m]", &R::resolution_m));
  }
};

// The numerator of z''/w (measure.hpp).
enum class Form : std::uint8_t { linear, quadratic };
constexpr std::array<std::string_view, 2> names_of(Form) { return {"linear", "quadratic"}; }

// One property of one form, on random input.
struct FormRow {
  Form form = Form::linear;
  std::string property, arithmetic;
  double far_near_ratio = 0;
  std::size_t samples = 0, violations = 0;
  double max_deviation_ndc = 0;  // where the property has none, 0
  double max_deviation_m = 0;    // the same as a distance

  static constexpr std::string_view kName = "depth_monotone";
  static constexpr std::string_view kTitle =
      "Depth z''/w with a linear and with a quadratic numerator";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Linear: z'' = ((f+n) d - 2fn) / (f-n); quadratic: z'' = (2d^2 - (f+n) d) / (f-n); d the distance, near at 1 m. Monotone: of neighbouring floats the farther has the larger depth (in float and double: not a smaller one). Lines stay straight: depth interpolated over the screen is the edge's depth. Nearer wins: of two edges in one pixel."};
  static constexpr auto columns() {
    using R = FormRow;
    return std::tuple(column("form", &R::form), column("property", &R::property),
                      column("arithmetic", &R::arithmetic),
                      column("far_near_ratio", "far/near", &R::far_near_ratio),
                      column("samples", &R::samples), column("violations", &R::violations),
                      column("max_deviation_ndc", "max dev. [NDC]", &R::max_deviation_ndc),
                      column("max_deviation_m", "max dev. [m]", &R::max_deviation_m));
  }
};

// A view-space point taken to clip space.
struct EyePlaneRow {
  std::string arithmetic;
  double x = 0, y = 0, z = 0, w = 0;
  int divisible = 0;  // 1: w is not 0

  static constexpr std::string_view kName = "depth_eye_plane";
  static constexpr std::string_view kTitle =
      "The point (1, 1, 0) in clip space: l = b = -1, r = t = 1, n = 1, f = 10";
  static constexpr auto columns() {
    using R = EyePlaneRow;
    return std::tuple(column("arithmetic", &R::arithmetic), column("x_clip", "x", &R::x),
                      column("y_clip", "y", &R::y), column("z_clip", "z", &R::z),
                      column("w_clip", "w", &R::w), column("divisible", &R::divisible));
  }
};

// Resolution over distance.
Plot curve_plot(const std::vector<CurveRow>& curve);
// The share of neighbours that a float pipeline does not put in order, over far / near.
Plot lost_order_plot(const std::vector<PrecisionRow>& precision);

std::string finding(const std::vector<PrecisionRow>& precision, const std::vector<FormRow>& forms);

}  // namespace clipscope::experiments::depth

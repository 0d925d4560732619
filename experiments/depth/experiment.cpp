// SPDX-License-Identifier: GPL-3.0-or-later
//
// Depth: conventions x far/near ratios x formats x arithmetic, and what makes a depth usable at all.
#include <fmt/format.h>

#include "experiments/depth/depth_precision.hpp"
#include "experiments/depth/pseudo_depth.hpp"
#include "experiments/depth/tables.hpp"
#include "experiments/experiment.hpp"
#include "experiments/report/progress.hpp"

namespace clipscope::experiments {
namespace {

constexpr float kNear = 0.1f;  // m
constexpr std::array kRatios = {1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7};
constexpr double kCurveRatio = 1e5;  // of the curve over distance: 0.1 m to 10 km
constexpr std::size_t kExact = 500;  // distances whose error is taken against rationals

float far_of(double ratio) { return static_cast<float>(kNear * ratio); }

// The same distances for every convention: the seed is that of the run.
std::vector<float> distances_for(const Selection& selection, double ratio) {
  Random random(selection.seed);
  const std::size_t count = selection.sample != 0 ? selection.sample
                            : selection.quick     ? 2000
                                                  : 10000;
  return spread_distances(kNear, far_of(ratio), count, random);
}

void measure_precision(const Selection& selection, const DepthConvention& convention, double ratio,
                       Table& table, CellRecord& record) {
  const std::vector<float> distances = distances_for(selection, ratio);
  const std::size_t stride = std::max<std::size_t>(1, distances.size() / kExact);
  for (const DepthFormat format : kDepthFormats) {
    for (const DepthArithmetic arithmetic : depth_arithmetics(selection)) {
      const DepthBuffer buffer(convention, format, arithmetic, kNear, far_of(ratio));
      add_depth_precision_row(table, record, convention, format, arithmetic, ratio,
                              measure_depth(buffer, distances, stride));
    }
  }
}

void measure_curve(const DepthConvention& convention, Table& table) {
  Random random(1);
  const std::vector<float> distances = spread_distances(kNear, far_of(kCurveRatio), 24, random);
  for (const DepthFormat format : {DepthFormat::unorm24, DepthFormat::float32}) {
    const DepthBuffer buffer(convention, format, DepthArithmetic::in_float, kNear,
                             far_of(kCurveRatio));
    for (const float distance : distances) {
      const std::optional<double> metres = resolution(buffer, distance);
      if (!metres) continue;
      table.add_row({std::string(convention.name), std::string(format_name(format)),
                     double{distance}, *metres});
    }
  }
}

}  // namespace

void run_depth(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  Table precision = depth_precision_table();
  Table curve = depth_curve_table(kCurveRatio);
  Table forms = depth_forms_table();
  Table eye = depth_eye_plane_table();
  Progress progress("depth", kDepthConventions.size() * (kRatios.size() + 1) + 1);
  for (const DepthConvention& convention : kDepthConventions) {
    for (const double ratio : kRatios) {
      context.cell(fmt::format("{} {}", convention.name, ratio), {&precision},
                   [&](CellRecord& record) {
                     measure_precision(selection, convention, ratio, precision, record);
                   });
      progress.advance();
    }
    context.cell(fmt::format("{} curve", convention.name), {&curve},
                 [&](CellRecord&) { measure_curve(convention, curve); });
    progress.advance();
  }
  context.cell("forms", {&forms, &eye}, [&](CellRecord&) {
    Random random(selection.seed);
    const std::size_t samples = selection.quick ? 500 : 5000;
    for (const double ratio : {1e1, 1e4}) {
      add_form_rows(forms, ratio, check_depth_forms(1, static_cast<float>(ratio), samples, random));
    }
    for (const EyePlanePoint& point : point_beside_the_eye()) add_eye_plane_row(eye, point);
  });
  progress.advance();
  for (const Table* table : {&precision, &curve, &forms, &eye}) context.emit(*table);
  context.emit(depth_curve_plot(curve));
  context.emit(depth_lost_order_plot(precision));
  context.finding(depth_finding(precision, forms));
}

}  // namespace clipscope::experiments

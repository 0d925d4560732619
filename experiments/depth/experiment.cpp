// SPDX-License-Identifier: GPL-3.0-or-later
//
// Depth: conventions x far/near ratios x formats x arithmetic, and what makes a depth usable at
// all.
#include <fmt/format.h>

#include <cmath>

#include "experiments/depth/measure.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/report/experiment.hpp"
#include "experiments/table/hex_float.hpp"

namespace clipscope::experiments::depth {
namespace {

constexpr float kNear = 0.1f;  // m
constexpr std::array kRatios = {1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7};
constexpr double kCurveRatio = 1e5;  // of the curve over distance: 0.1 m to 10 km
constexpr std::size_t kExact = 500;  // distances whose error is taken against rationals

float far_of(double ratio) { return static_cast<float>(kNear * ratio); }

void measure_precision(const Selection& selection, const Convention& convention, double ratio,
                       TableOf<PrecisionRow>& table, PieceRecord& record) {
  Random random(selection.seed);  // the same distances for every convention
  const float far = far_of(ratio), middle = std::sqrt(double{kNear} * far);
  const std::vector<float> distances =
      spread_distances(kNear, far, selection.sample_or(2000, 10000), random);
  const std::size_t stride = std::max<std::size_t>(1, distances.size() / kExact);
  for (const Stored format : kStored) {
    for (const Arithmetic arithmetic : arithmetics_of(selection.scalars)) {
      const Buffer buffer(convention, format, arithmetic, kNear, far);
      const Order order = order_of(buffer, distances);
      const auto percent = [&](std::size_t part) {
        return 100.0 * static_cast<double>(part) / static_cast<double>(order.pairs);
      };
      double largest_ulp = 0;
      float worst = 0;
      for (std::size_t i = 0; i < distances.size(); i += stride) {
        const double ulp = buffer.error_ulp(distances[i]);
        if (ulp <= largest_ulp) continue;
        largest_ulp = ulp;
        worst = distances[i];
      }
      table.add({std::string(convention.name), format, arithmetic, ratio, resolution(buffer, kNear),
                 resolution(buffer, middle), resolution(buffer, far),
                 buffer.code(far) - buffer.code(kNear) + 1, order.distinct,
                 percent(order.misordered), percent(order.tied), largest_ulp});
      record.worst_inputs.push_back(
          {fmt::format("{} {} far/near {:g}", convention.name, name_of(format), ratio),
           std::string(name_of(arithmetic)), "depth_ulp", largest_ulp, "0 0 " + hex_float(-worst),
           ""});
    }
  }
}

void measure_curve(const Convention& convention, TableOf<CurveRow>& table) {
  Random random(1);
  const float far = far_of(kCurveRatio);
  const std::vector<float> distances = spread_distances(kNear, far, 24, random);
  for (const Stored format : {Stored::unorm24, Stored::float32}) {
    const Buffer buffer(convention, format, Arithmetic::in_float, kNear, far);
    for (const float distance : distances) {
      const std::optional<double> metres = resolution(buffer, distance);
      if (metres) table.add({std::string(convention.name), format, distance, *metres});
    }
  }
}

void check_numerators(const Selection& selection, TableOf<FormRow>& table) {
  Random random(selection.seed);
  for (const float far : {1e1f, 1e4f}) {
    for (const FormRow& row : check_forms(1, far, selection.quick ? 500 : 5000, random)) {
      table.add(row);
    }
  }
}

void run(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  TableOf<PrecisionRow> precision;
  TableOf<CurveRow> curve(
      std::string(CurveRow::kName),
      fmt::format("Resolution over distance, far/near = {:g}, transform in float", kCurveRatio));
  TableOf<FormRow> forms;
  TableOf<EyePlaneRow> eye;
  Progress progress("depth", kConventions.size() * (kRatios.size() + 1) + 1);
  for (const Convention& convention : kConventions) {
    for (const double ratio : kRatios) {
      context.piece(fmt::format("{} {}", convention.name, ratio), {&precision},
                    [&](PieceRecord& record) {
                      measure_precision(selection, convention, ratio, precision, record);
                    });
      progress.advance();
    }
    context.piece(fmt::format("{} curve", convention.name), {&curve},
                  [&](PieceRecord&) { measure_curve(convention, curve); });
    progress.advance();
  }
  context.piece("forms", {&forms, &eye}, [&](PieceRecord&) {
    check_numerators(selection, forms);
    for (const EyePlaneRow& row : point_beside_the_eye()) eye.add(row);
  });
  progress.advance();
  context.emit(precision, curve, forms, eye);
  context.emit(curve_plot(curve.rows()), lost_order_plot(precision.rows()));
  context.finding(finding(precision.rows(), forms.rows()));
}

}  // namespace

extern constinit const Experiment kExperiment{
    "depth", "How precise is depth, by depth convention and ratio of far to near?", run};

}  // namespace clipscope::experiments::depth

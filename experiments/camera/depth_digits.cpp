// SPDX-License-Identifier: GPL-3.0-or-later
//
// The step of distance that a depth buffer has left: the buffer's step divided by the slope of
// depth. With z = a + b / w the slope is |b| / w^2; a and b follow from near and far, where z has
// the ends of its range.
#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/camera/matrix_meaning.hpp"

namespace clipscope::experiments {
namespace {

constexpr double kMostNears = 1e6;   // powers of ten go so far where far is at infinity
constexpr double kJustBefore = 0.9;  // a power of ten so near to far would say the same

double ulp_of_float(double x) {
  const auto f = static_cast<float>(std::abs(x));
  return double{std::nextafter(f, HUGE_VALF)} - double{f};
}

// z = constant + slope / distance, or of a parallel projection constant + slope distance.
struct DepthCurve {
  bool perspective;
  double constant, slope;

  double at(double distance) const {
    return constant + (perspective ? slope / distance : slope * distance);
  }
  double steepness(double distance) const {
    return std::abs(perspective ? slope / (distance * distance) : slope);
  }
};

DepthCurve curve_of(const MatrixMeaning& m) {
  const double low = m.depth == DepthRange::minus_one_to_one ? -1 : 0;
  const double at_near = m.depth == DepthRange::reversed ? 1 : low;
  const double at_far = m.depth == DepthRange::reversed ? 0 : 1;
  const double near = m.reading().near.value, far = m.reading().far.value;
  if (!m.perspective) {
    const double slope = (at_far - at_near) / (far - near);
    return {false, at_near - slope * near, slope};
  }
  const double inverse_far = 1 / far;  // 0 at infinity
  const double slope = (at_near - at_far) / (1 / near - inverse_far);
  return {true, at_far - slope * inverse_far, slope};
}

std::vector<double> distances_of(const MatrixMeaning& m) {
  const double near = m.reading().near.value, far = m.reading().far.value;
  std::vector<double> distances = {near};
  if (m.perspective) {
    for (double d = 10 * near; d < std::min(kJustBefore * far, 2 * kMostNears * near); d *= 10) {
      distances.push_back(d);
    }
  }
  if (std::isfinite(far)) distances.push_back(far);
  return distances;
}

}  // namespace

std::vector<DepthDigits> depth_digits(const MatrixMeaning& m) {
  if (m.singular || !m.reading().encloses_volume) return {};
  const DepthCurve curve = curve_of(m);
  const bool halved = m.depth == DepthRange::minus_one_to_one;
  const double share = halved ? 0.5 : 1;  // of z in the buffer
  const auto stored = [&](double z) { return halved ? (z + 1) / 2 : z; };
  const double far = m.reading().far.value;
  const double stored_far = m.depth == DepthRange::reversed ? 0 : 1;
  std::vector<DepthDigits> rows;
  for (const double distance : distances_of(m)) {
    DepthDigits& row =
        rows.emplace_back(DepthDigits{.distance = distance, .depth = curve.at(distance)});
    const double in_buffer = stored(row.depth);
    const std::array<double, kDepthBuffers> steps = {
        1 / 65535.0, 1 / 16777215.0,
        std::max(ulp_of_float(in_buffer), share * ulp_of_float(row.depth))};
    const double reach = m.perspective ? distance : far - m.reading().near.value;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      row.step[i] = steps[i] / (share * curve.steepness(distance));
      row.digits[i] = std::log10(reach / row.step[i]);
    }
    const double left = std::abs(stored_far - in_buffer);
    row.values_left = {std::round(left * 65535), std::round(left * 16777215)};
  }
  return rows;
}

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/exact_questions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/judge/promise.hpp"

namespace clipscope::experiments {
namespace {

// The next number of the format below (-1) or above (1).
double next_number(const Format& format, double x, int direction) {
  const double to = direction * std::numeric_limits<double>::infinity();
  if (format.is_float()) return std::nextafter(static_cast<float>(x), static_cast<float>(to));
  return std::nextafter(x, to);
}

// value - exact < 0, = 0 or > 0. The value may be infinite.
double side_of(double value, const reference::Fraction& exact) {
  return std::isfinite(value) ? reference::error_of(value, exact) : value;
}

bool is_faithful(const Format& format, const Number& number, const reference::Fraction& exact,
                 double approximation) {
  if (is_nan(number)) return false;
  if (format.is_exact()) return to_exact(number) == reference::to_rational(exact);
  const double x = number.value;
  // Two units off, the approximation settles it.
  if (std::abs(x - approximation) > 2 * format.ulp_at(approximation) && std::isfinite(x)) {
    return false;
  }
  return side_of(next_number(format, x, -1), exact) < 0 &&
         side_of(next_number(format, x, 1), exact) > 0;
}

bool is_faithful(const Format& format, const VertexView& vertex, const TruthPolygon& truth,
                 std::size_t exact_vertex) {
  for (std::size_t i = 0; i < vertex.size(); ++i) {
    if (!is_faithful(format, vertex[i],
                     coordinate(truth.exact.vertices[exact_vertex], static_cast<int>(i)),
                     truth.approximation[exact_vertex][i])) {
      return false;
    }
  }
  return true;
}

// Whether each vertex of one side has a faithful partner on the other, both ways.
bool has_partners(const PolygonView& polygon, const TruthPolygon& truth) {
  const std::size_t n = truth.exact.vertices.size();
  std::vector<char> is_met(n, false);
  for (const VertexView& vertex : polygon) {
    bool found = false;
    for (std::size_t i = 0; i < n; ++i) {
      if (!is_faithful(polygon.format(), vertex, truth, i)) continue;
      found = true;
      is_met[i] = true;
    }
    if (!found) return false;
  }
  return std::ranges::all_of(is_met, [](char met) { return met != 0; });
}

std::string unfaithful_reason(const Comparison& comparison) {
  if (comparison.outcome > Outcome::visible) {
    return fmt::format("not faithful: {}",
                       kOutcomeNames[static_cast<std::size_t>(comparison.outcome)]);
  }
  if (comparison.position_ulp > 1) {
    return fmt::format("not faithful: a coordinate is {:.3g} ulp off", comparison.position_ulp);
  }
  return fmt::format("not faithful: a coordinate or attribute is not next to the exact value");
}

}  // namespace

Found judge_winding(const Comparison& comparison) {
  if (comparison.outcome != Outcome::flipped) return Found::kept();
  return Found::broken("the winding is reversed");
}

Found judge_faithful(const PolygonView& polygon, const TruthPolygon& truth,
                     const Comparison& comparison) {
  if (polygon.format().precision == kFormat<dd_real>.precision) return {};
  if (!comparison.visible && comparison.outcome == Outcome::exact) return Found::kept();
  if (comparison.outcome != Outcome::flipped && has_partners(polygon, truth)) return Found::kept();
  Found found = Found::broken(unfaithful_reason(comparison));
  const bool is_measured = comparison.outcome <= Outcome::visible && comparison.position_ulp > 1;
  if (is_measured) found.excess = comparison.position_ulp;
  return found;
}

Found judge_correctly_rounded(const PolygonView& polygon, const TruthPolygon& truth) {
  if (!polygon.format().is_float()) return {};
  return Found{.judged = true, .reason = misrounded_in_any_order(truth.exact, polygon)};
}

}  // namespace clipscope::experiments

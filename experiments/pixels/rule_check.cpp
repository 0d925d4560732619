// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/pixels/rule_check.hpp"

#include <algorithm>
#include <cmath>

namespace clipscope::experiments {
namespace {

// Values that are right, closed; empty if least > greatest.
struct Range {
  double least = 0, greatest = 0;

  double distance(double v) const { return std::max({least - v, v - greatest, 0.0}); }
};

double clamped(double v) { return std::clamp(v, 0.0, 1.0); }

Range with_clamping(Range range, Clamping clamping) {
  const Range inside{clamped(range.least), clamped(range.greatest)};
  if (clamping == Clamping::must) return inside;
  if (clamping == Clamping::never) return range;
  return {std::min(range.least, inside.least), std::max(range.greatest, inside.greatest)};
}

// On a square around the centre. A quotient of linear functions is greatest and least at corners if
// its denominator is positive at all of them; otherwise it may be anything.
Range range_around(const Interpolant& of, const PixelPlace& place) {
  Range range{INFINITY, -INFINITY};
  for (const double dx : {-place.reach_px, place.reach_px}) {
    for (const double dy : {-place.reach_px, place.reach_px}) {
      const PixelWeights at = place.primitive.weights_beside(place.at, dx, dy);
      if (of.is_perspective && at.sum <= 0) return {-INFINITY, INFINITY};
      const double value = enclosed(of, at).value;
      range.least = std::min(range.least, value);
      range.greatest = std::max(range.greatest, value);
    }
  }
  return range;
}

// The value among those that are right that is nearest to the returned one.
double nearest_right(double exact, Clamping clamping, double returned) {
  if (clamping == Clamping::never) return exact;
  const double inside = clamped(exact);
  const bool is_nearer = std::abs(returned - inside) < std::abs(returned - exact);
  return clamping == Clamping::must || is_nearer ? inside : exact;
}

void measure(CheckedValue& checked, double size) {
  checked.ulps = std::abs(static_cast<double>(checked.returned) - checked.exact) / float_ulp(size);
}

// By how much of the slack the number is beyond, at least 1.
double beyond(double distance, double slack) {
  return slack > 0 ? distance / slack : std::numeric_limits<double>::infinity();
}

}  // namespace

CheckedValue check(const ValueRule& rule, const PixelPlace& place, float returned) {
  CheckedValue checked;
  checked.returned = returned;
  const Enclosed exact = enclosed(rule.interpolant, place.at);
  checked.exact = nearest_right(exact.value, rule.clamping, returned);
  checked.is_apart = !(exact.size <= kGreatest);
  if (checked.is_apart) return checked;
  if (!std::isfinite(returned)) {
    checked.violation = ViolationKind::not_finite;
    checked.size = std::numeric_limits<double>::infinity();
    return checked;
  }
  const double value = returned;
  const Range near = with_clamping(range_around(rule.interpolant, place), rule.clamping);
  measure(checked, rule.size);
  if (std::abs(value - checked.exact) <= rule.slack) return checked;
  if (near.distance(value) <= rule.slack) return checked;
  const double beyond_hull =
      with_clamping({rule.least, rule.greatest}, rule.clamping).distance(value);
  const bool is_in_hull = beyond_hull <= rule.slack;
  if (is_in_hull && (!place.is_inside || rule.has_linear_twin)) return checked;
  checked.violation = is_in_hull ? ViolationKind::wrong_value : ViolationKind::outside_hull;
  checked.size = beyond(is_in_hull ? near.distance(value) : beyond_hull, rule.slack);
  return checked;
}

CheckedValue check_constant(const ValueRule& rule, float returned) {
  CheckedValue checked;
  checked.returned = returned;
  checked.exact = nearest_right(rule.least, rule.clamping, returned);
  checked.is_apart = !(std::abs(checked.exact) <= kGreatest);
  if (checked.is_apart) return checked;
  const double error = std::abs(static_cast<double>(returned) - checked.exact);
  if (!std::isfinite(returned)) {
    checked.violation = ViolationKind::not_finite;
    checked.size = std::numeric_limits<double>::infinity();
  } else if (error > rule.slack) {
    checked.violation = ViolationKind::wrong_value;
    checked.size = beyond(error, rule.slack);
  } else {
    measure(checked, std::abs(checked.exact));
  }
  return checked;
}

std::vector<ValueRule> rules_of_point(const DrawCall& call, std::uint32_t vertex) {
  const DrawVertex& v = call.vertices[vertex];
  std::vector<ValueRule> rules;
  const auto add = [&](Quantity quantity, std::size_t channel, double value, double size) {
    if (!call.quantities[bit(quantity)]) return;
    ValueRule rule{quantity, channel};
    rule.least = rule.greatest = value;
    rule.slack = kEpsilon * (kInterpolation + kTransform) * size;
    const bool is_depth = quantity == Quantity::depth;
    if (is_depth || (quantity == Quantity::frag_coord && channel == 2)) {
      rule.clamping = is_depth && call.volume.depth_clamp ? Clamping::must : Clamping::may;
    }
    rules.push_back(rule);
  };
  for (std::size_t c = 0; c < 4; ++c) {
    const double value = v.varying[c];
    add(Quantity::smooth, c, value, std::abs(value));
    add(Quantity::noperspective, c, value, std::abs(value));
  }
  for (std::size_t c = 0; c < static_cast<std::size_t>(call.volume.clip_distances); ++c) {
    const double value = v.clip_distances[c];
    add(Quantity::clip_distances, c, value, std::abs(value));
  }
  const double inv_w = 1 / static_cast<double>(v.position[3]);
  const double z = v.position[2] * inv_w;
  const bool is_symmetric = call.volume.depth == DepthRange::minus_one_to_one;
  const double depth = is_symmetric ? (z + 1) / 2 : z;
  add(Quantity::frag_coord, 2, depth, std::abs(z) + 1);
  add(Quantity::frag_coord, 3, inv_w, std::abs(inv_w));
  add(Quantity::depth, 0, depth, std::abs(z) + 1);
  return rules;
}

void settle_value(const ValueJudge& judge, std::size_t primitive, const ValueRule& rule,
                  const CheckedValue& checked, int x, int y) {
  if (checked.is_apart) return;
  const WorstPixel pixel{x, y, rule.channel, checked.exact, checked.returned};
  if (checked.violation) {
    judge.accusations.add(primitive, rule.quantity, *checked.violation, pixel, checked.size);
  } else {
    judge.judgement.errors[bit(rule.quantity)].add(checked.ulps, pixel);
  }
}

}  // namespace clipscope::experiments

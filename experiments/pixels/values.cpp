// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/pixels/values.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/pixels/rule_check.hpp"
#include "experiments/pixels/rules.hpp"

namespace clipscope::experiments {
namespace {

constexpr double kNothingAllowed = std::numeric_limits<double>::infinity();

// 1 or -1; 0 where either is right.
int facing_of(const DrawCall& call, const JudgedPrimitive& primitive, bool is_certain) {
  if (!primitive.is_triangle()) return 1;
  int behind = 0;
  for (const std::uint32_t number : primitive.vertices) {
    const float w = call.vertices[number].position[3];
    if (w == 0) return 0;
    behind += w < 0 ? 1 : 0;
  }
  return is_certain && behind % 2 == 0 ? primitive.exact->orientation() : 0;
}

class PrimitiveValues {
 public:
  PrimitiveValues(const ValueJudge& judge, std::size_t number, const JudgedPrimitive& primitive,
                  bool is_certain)
      : judge_(judge),
        number_(number),
        primitive_(primitive),
        provoking_(judge.call.vertices[provoking_vertex(judge.call, number)]),
        facing_(facing_of(judge.call, primitive, is_certain)) {
    if (!primitive.exact) rules_ = rules_of_point(judge.call, primitive.vertices[0]);
    if (primitive.has_values()) rules_ = rules_of(judge.call, primitive.vertices);
  }

  void judge_pixel(int x, int y) {
    judge_whole_numbers(x, y);
    judge_flat(x, y);
    if (rules_.empty()) return;
    if (!primitive_.exact) {
      for (const ValueRule& rule : rules_) {
        settle(rule, check_constant(rule, returned(rule, x, y)), x, y);
      }
      return;
    }
    const PixelPlace place{*primitive_.exact,
                           primitive_.exact->weights(x, y),
                           x,
                           y,
                           primitive_.region.displacement_px,
                           primitive_.region.is_inside};
    for (const ValueRule& rule : rules_) {
      const float value = returned(rule, x, y);
      const Enclosed exact = enclosed(rule.interpolant, place.at);
      const double ulps = ulps_at_centre(rule, exact, value);
      if (ulps >= 0) {
        judge_.judgement.errors[bit(rule.quantity)].add(ulps,
                                                        {x, y, rule.channel, exact.value, value});
      } else {
        settle(rule, check(rule, place, value), x, y);
      }
    }
  }

 private:
  float returned(const ValueRule& rule, int x, int y) const {
    return judge_.pixels.at(rule.quantity, x, y, rule.channel);
  }

  void settle(const ValueRule& rule, const CheckedValue& checked, int x, int y) {
    settle_value(judge_, number_, rule, checked, x, y);
  }

  void expect(Quantity quantity, std::size_t channel, double right, ViolationKind kind, int x,
              int y) {
    if (judge_.pixels.of(quantity).empty()) return;
    const float value = judge_.pixels.at(quantity, x, y, channel);
    if (static_cast<double>(value) == right) return;
    judge_.accusations.add(number_, quantity, kind, {x, y, channel, right, value}, kNothingAllowed);
  }

  void judge_whole_numbers(int x, int y) {
    expect(Quantity::primitive_id, 0, static_cast<double>(number_), ViolationKind::primitive_id, x,
           y);
    expect(Quantity::frag_coord, 0, x + 0.5, ViolationKind::wrong_value, x, y);
    expect(Quantity::frag_coord, 1, y + 0.5, ViolationKind::wrong_value, x, y);
    if (facing_ == 0) return;
    expect(Quantity::facing, 0, facing_, ViolationKind::facing, x, y);
    if (judge_.pixels.at(Quantity::hits, x, y) == 1) {
      expect(Quantity::hits, 1, facing_ > 0 ? 1 : 0, ViolationKind::facing, x, y);
    }
  }

  void judge_flat(int x, int y) {
    if (judge_.pixels.of(Quantity::flat).empty()) return;
    for (std::size_t c = 0; c < 4; ++c) {
      const double right = provoking_.varying[c];
      const double value = judge_.pixels.at(Quantity::flat, x, y, c);
      const bool is_interpolated = judge_.info.api == GraphicsApi::webgl;
      const double slack = is_interpolated ? kEpsilon * kInterpolation * std::abs(right) : 0;
      if (std::abs(value - right) <= slack) continue;
      expect(Quantity::flat, c, right, ViolationKind::flat_value, x, y);
    }
  }

  const ValueJudge& judge_;
  std::size_t number_;
  const JudgedPrimitive& primitive_;
  const DrawVertex& provoking_;
  int facing_;
  std::vector<ValueRule> rules_;
};

}  // namespace

void judge_values(const ValueJudge& judge, const std::vector<JudgedPrimitive>& primitives,
                  const CoverageMap& map) {
  std::vector<std::optional<PrimitiveValues>> values(primitives.size());
  for (int y = 0; y < judge.pixels.height; ++y) {
    for (int x = 0; x < judge.pixels.width; ++x) {
      const PixelClaim& claim = map.at(x, y);
      const int all = claim.covered + claim.open;
      if (all == 0 || judge.pixels.at(Quantity::hits, x, y) != static_cast<float>(all)) continue;
      const auto i = static_cast<std::size_t>(claim.last);
      if (!values[i]) values[i].emplace(judge, i, primitives[i], map.is_certain[i]);
      values[i]->judge_pixel(x, y);
    }
  }
}

}  // namespace clipscope::experiments

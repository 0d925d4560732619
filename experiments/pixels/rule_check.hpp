// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks one returned number against its rule (values.hpp has what is legal).
#pragma once

#include <cstdint>
#include <optional>

#include "experiments/pixels/rules.hpp"
#include "experiments/pixels/values.hpp"

namespace clipscope::experiments {

struct PixelPlace {
  const ExactPrimitive& primitive;
  PixelWeights at;
  int x = 0, y = 0;
  double reach_px = 0;     // how far from the centre the value may be taken
  bool is_inside = false;  // not clipped: only the value there is right
};

struct CheckedValue {
  double exact = 0;
  float returned = 0;
  double ulps = 0;
  std::optional<ViolationKind> violation = {};
  double size = 0;        // of the violation
  bool is_apart = false;  // nothing is promised of it
};

// Its error if the value at the centre itself makes it legal, as it nearly always does; negative if
// it takes `check` to know.
inline double ulps_at_centre(const ValueRule& rule, const Enclosed& exact, float returned) {
  const double error = std::abs(returned - exact.value);
  const bool may_clamp = rule.clamping != Clamping::never && (exact.value < 0 || exact.value > 1);
  const bool is_legal = error <= rule.slack && exact.size <= kGreatest && !may_clamp;
  return is_legal ? error / float_ulp(rule.size) : -1;
}

CheckedValue check(const ValueRule& rule, const PixelPlace& place, float returned);
// Of a point: least is the value.
CheckedValue check_constant(const ValueRule& rule, float returned);

// smooth, noperspective, z and w of frag_coord, depth and clip distances of a point.
std::vector<ValueRule> rules_of_point(const DrawCall& call, std::uint32_t vertex);

// Accuses, or counts the error.
void settle_value(const ValueJudge& judge, std::size_t primitive, const ValueRule& rule,
                  const CheckedValue& checked, int x, int y);

}  // namespace clipscope::experiments

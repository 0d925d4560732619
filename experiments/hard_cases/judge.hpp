// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a clipper makes of a hard case, and whether that is right.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/measure/compare.hpp"
#include "experiments/measure/promise.hpp"

namespace clipscope::experiments {

struct CaseAnswer {
  std::vector<std::array<double, 4>> polygon;  // x y z 1/w, each exact or the nearest double
  Comparison comparison;  // outcome not_applicable if the method does not take such input
};

// A clipper in one scalar, for one kind of primitive.
struct CaseContestant {
  std::string clipper, scalar;
  // Pre-condition: the case is of that kind and finite, and the truth is the case's own.
  std::function<CaseAnswer(const HardCase&, const TruthPolygon&)> answer;
  // The polygon alone, for input that need not be finite.
  std::function<CaseAnswer(const HardCase&)> polygon_of;
  // For triangles only, else empty: does the answer keep the clipper's promise?
  std::function<PromiseCheck(const HardCase&)> keeps_promise;
};

// Those that match the pattern and the scalars (see select_contestants); none if there are none of
// that primitive. Errors: UsageError for unknown scalars.
std::vector<CaseContestant> case_contestants(Primitive primitive, std::string_view clipper_pattern,
                                             const std::vector<std::string>& scalars);

TruthPolygon truth_polygon(const HardCase& hard_case);

}  // namespace clipscope::experiments

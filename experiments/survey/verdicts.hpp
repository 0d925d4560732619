// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verdicts: what contestants make of hard cases and of the families around these, and whether that
// is right.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/contestants/contestant.hpp"
#include "experiments/judge/compare.hpp"
#include "experiments/judge/promise.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/selection/select.hpp"

namespace clipscope::experiments {

// The contestants for the primitive that match the pattern and the scalars (see
// select_contestants); none where the pattern names clippers of another primitive.
Contestants case_contestants(Primitive primitive, std::string_view clipper_pattern,
                             const std::vector<std::string>& scalars);

// The same of what the user selected, guests included.
Contestants case_contestants(Primitive primitive, const Selection& selection,
                             const std::vector<std::string>& scalars);

bool takes(const Contestant& contestant, const HardCase& hard_case);

// Pre-condition: the contestant takes the case. The case need not be finite.
Answers clip_case(const Contestant& contestant, const HardCase& hard_case);

// Outcome not_applicable if the contestant does not take the case. Pre-condition: the case is
// finite, and the truth is its own.
Comparison judge_case(const Contestant& contestant, const HardCase& hard_case,
                      const TruthPolygon& truth);

// Whether the answer keeps the contestant's promise. Pre-condition: the case is a finite triangle.
PromiseCheck check_case(const Contestant& contestant, const HardCase& hard_case);

TruthPolygon truth_polygon(const HardCase& hard_case);

// x y z 1/w of each vertex, as doubles.
std::vector<std::array<double, 4>> positions_of(const PolygonView& polygon);

// What to judge: the cases of one primitive, and who is judged.
struct CaseSet {
  Primitive primitive = Primitive::triangle;
  std::vector<const HardCase*> cases;
  Contestants contestants;
};

struct CaseVerdict {
  Comparison comparison;
  PromiseCheck promise;  // of triangles; else kept
};

// One row per case, in it one verdict per contestant. In parallel; the result does not depend on
// it.
std::vector<std::vector<CaseVerdict>> judge_cases(const CaseSet& set, Progress& progress);

// What a contestant did on all variants of all cases.
struct FamilyTally {
  std::int64_t variants = 0;                // that it takes
  std::int64_t failures = 0;                // see is_failure
  std::int64_t broken = 0;                  // promises
  std::optional<double> largest_ulps = {};  // backward error of triangles, in units of the promise
  std::string worst = "";                   // name of the variant with it, where it is not 0
  std::string offender = "";                // the first variant that breaks a promise, and how

  void add(const CaseVerdict& verdict, const HardCase& variant);
  FamilyTally& operator+=(const FamilyTally& next);  // of variants that come after
};

// One tally per contestant, over families and special values that are finite.
std::vector<FamilyTally> judge_families(const CaseSet& set, Progress& progress);

// What a contestant did with NaN and infinities in positions: the policy of spaces/clipper.hpp is
// that nothing comes out.
struct PolicyTally {
  std::int64_t inputs = 0;
  std::int64_t drawn = 0;     // something came out
  std::string offender = "";  // name of the first variant that it came out of

  PolicyTally& operator+=(const PolicyTally& next);  // of variants that come after
};

std::vector<PolicyTally> judge_special_values(const CaseSet& set, Progress& progress);

}  // namespace clipscope::experiments

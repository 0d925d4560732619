// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verdicts: every clipper on every case of a catalogue, and on the families around the cases.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "experiments/hard_cases/judge.hpp"
#include "experiments/report/progress.hpp"

namespace clipscope::experiments {

// What to judge: the cases of one primitive, and who is judged.
struct CaseSet {
  Primitive primitive = Primitive::triangle;
  std::vector<const HardCase*> cases;
  std::vector<CaseContestant> contestants;
};

struct CaseVerdict {
  Comparison comparison;
  PromiseCheck promise;  // of triangles; else kept
};

// One row per case, in it one verdict per contestant. In parallel; the result does not depend on it.
std::vector<std::vector<CaseVerdict>> judge_cases(const CaseSet& set, Progress& progress);

// What a contestant did on all variants of all cases.
struct FamilyTally {
  std::int64_t variants = 0;  // that it takes
  std::int64_t failures = 0;  // see is_failure
  std::int64_t broken = 0;    // promises
  double largest_ulps = 0;    // backward error, in units of the promise, where it applies
  std::string worst;          // name of the variant with it
  std::string offender;       // the first variant that breaks a promise, and how
};

// One tally per contestant, over families and special values that are finite.
std::vector<FamilyTally> judge_families(const CaseSet& set, Progress& progress);

// What a contestant did with NaN and infinities in positions: the policy of spaces/clipper.hpp is that
// nothing comes out.
struct PolicyTally {
  std::int64_t inputs = 0;
  std::int64_t drawn = 0;  // something came out
  std::string offender;    // name of the first variant of these
};

std::vector<PolicyTally> judge_special_values(const CaseSet& set, Progress& progress);

}  // namespace clipscope::experiments

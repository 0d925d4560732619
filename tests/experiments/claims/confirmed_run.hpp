// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run in which every claim is confirmed but the published rankings, no run being able to confirm
// all of them, since they name several as the fastest; and what changes the verdicts.
#pragma once

#include <functional>
#include <vector>

#include "experiments/claims/claim.hpp"
#include "experiments/cost/rows.hpp"
#include "experiments/frontier/rows.hpp"
#include "tests/experiments/claims/fabricated.hpp"

namespace clipscope::experiments::claims {

// So many ns, and so many times faster than the baseline, to 0.1.
Timing timing(double ns, double speedup);

std::vector<cost::Row> costs();
std::vector<CountRow> counts();

// Each table as small as its judges allow.
Fabricated all_confirmed();

// What one changed row makes of a claim.
struct Alteration {
  int claim;
  std::function<void(Fabricated&)> alter;
  Verdict verdict;
};

// At least one for every claim that is no ranking.
std::vector<Alteration> alterations();

}  // namespace clipscope::experiments::claims

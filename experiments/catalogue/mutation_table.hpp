// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which cases notice which bug: the catalogue against the textbook clipper with seeded bugs
// (reference/mutants.hpp).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"
#include "reference/mutants.hpp"

namespace clipscope::experiments {

struct MutationRow {
  reference::Bug bug;
  std::string_view name, summary;
  std::vector<std::string> caught_by;  // names of cases, in the order of the catalogue
  std::string
      sharpest;  // of these the first of those that catch the fewest bugs; empty if there are none
};

// One row per bug, in the order of all_bugs().
std::vector<MutationRow> mutation_table(std::span<const HardCase> cases);

// The cases that notice the bug.
std::vector<std::string> caught_by(reference::Bug bug, std::span<const HardCase> cases);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Seeded bugs as guests: the textbook clipper over rational numbers with one of the bugs of
// reference/mutants.hpp, each number of its answer rounded once. What the bug does is all that is
// wrong with it, so that whoever looks for failures can be tested on them.
//
// They are called "seeded/skips_left" and so on, and are contestants only once they were asked for
// by name: `*` never means them.
#pragma once

#include <string_view>
#include <vector>

#include "experiments/contestants/contestant.hpp"

namespace clipscope::experiments {

// "seeded/absolute_w" and so on, in the order of reference::all_bugs().
std::vector<std::string_view> seeded_names();

// Adds the guest of that name, for triangles, in that scalar, unless it is there. Nothing happens
// where no seeded bug has the name, or in a scalar other than float, double and exact.
void add_if_seeded(std::string_view clipper, std::string_view scalar);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draw calls with what is exactly right in a pixel, for the tests.
#pragma once

#include <string>
#include <vector>

#include "experiments/reproductions/reproduction.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments {

// (0,0,1/2,1) (4,0,1/2,1) (0,4,1,2): on the sides, and its depths are all 3/4 in the window.
DrawCall corner_triangle();

// A claim about one pixel that a right driver fulfils, and what a wrong one would do there.
struct Claim {
  std::string name;
  DrawCall call;
  Violation wrong;
};
// One of each kind of check, with what calls may have: points, strips, indices, clip distances,
// depth clamp, a viewport of its own.
std::vector<Claim> right_claims();

// The claim turned round: what the driver draws is said to be wrong, so it fails on a right one.
Claim turned(Claim claim);

// The text of the reproduction with that extension; empty if there is none.
std::string text_of(const Claim& claim, const std::string& extension);

// Whether a program is in the search path. Warns if not, or fails where the variable of the
// environment is set.
bool is_there_or_not_required(const std::string& program, const char* variable);

}  // namespace clipscope::experiments

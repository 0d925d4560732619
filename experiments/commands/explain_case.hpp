// SPDX-License-Identifier: GPL-3.0-or-later
//
// One primitive explained in words and numbers, on standard output.
#pragma once

#include <string>
#include <string_view>

#include "experiments/catalogue/hard_case.hpp"

namespace clipscope::experiments {

// Prints where the vertices are in each space, of a triangle also each cut in each space in that scalar;
// then the clipper's vertices, each coordinate beside the exact one. The case may come from anywhere; its
// numbers are finite. Returns the name of the clipper.
// Clipper: a name, or a pattern that only one clipper of that primitive matches; polygons have one.
// Errors: UsageError if there is no such clipper or scalar, or if the clipper doesn't take such input.
std::string explain_case(const HardCase& hard_case, std::string_view clipper,
                         std::string_view scalar);

}  // namespace clipscope::experiments

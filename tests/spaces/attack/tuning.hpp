// SPDX-License-Identifier: GPL-3.0-or-later
//
// Floats of a triangle's vertices, chosen so that an exact number of the answer comes as near as
// can be to where a decision flips.
#pragma once

#include <cstddef>

#include "tests/spaces/attack/dice.hpp"
#include "tests/spaces/attack/input.hpp"

namespace clipscope::attack {

// Moves number `place` (of a vertex's floats) of one vertex so that the number which a new vertex
// of the answer has there comes next to half way between two floats. Pre-condition: no plane that
// cuts depends on it. Does nothing if there is no new vertex.
void tune_to_tie(Dice& dice, Batch& batch, std::size_t triangle, std::size_t place);

// The same in NDC, so that it comes next to where the quotient rounds to infinity.
void tune_to_overflow(Dice& dice, Batch& batch, std::size_t triangle, std::size_t place);

// The same, so that it comes next to 0 beside its terms.
void tune_to_zero(Dice& dice, Batch& batch, std::size_t triangle, std::size_t place);

}  // namespace clipscope::attack

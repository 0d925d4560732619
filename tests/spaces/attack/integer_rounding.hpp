// SPDX-License-Identifier: GPL-3.0-or-later
//
// A quotient of integers as the nearest float, by integer arithmetic alone.
#pragma once

#include <gmpxx.h>

#include <array>

namespace clipscope::attack {

using Integer = mpz_class;

// Floats are multiples of 2^-149: times 2^149 they are integers.
inline constexpr int kFloatScale = 149;

// Pre-condition: finite.
Integer scaled(float x);

// Pre-condition: denominator > 0.
struct Quotient {
  Integer numerator, denominator;
};

// The float nearest to a quotient, ties to even, and how it came about.
struct Nearest {
  float value = 0;        // 0 is +0; what rounds to 0 from below is -0
  bool is_exact = false;  // nothing was rounded
  bool is_tie = false;    // half way between two floats
  bool went_up = false;   // in magnitude
  int zeros_to_tie = 0;   // the distance to half way is less than 2^-zeros_to_tie units in the last
                          // place; 0 for a tie
};
Nearest nearest(const Quotient& q);

}  // namespace clipscope::attack

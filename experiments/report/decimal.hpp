// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact numbers as decimals, and where an approximation first departs from them.
#pragma once

#include <string>

#include "reference/fraction.hpp"

namespace clipscope::experiments {

// The number in scientific notation with `digits` significant digits, truncated, never rounded:
// "-1.6666666666e-01"; "0" for zero.
std::string decimal(const reference::Rational& value, int digits);

// `approximation` to `digits` digits with the first digit that differs from `exact` in brackets,
// such as "3.33333[4]e-01"; without brackets if there is none. Another sign or power of ten puts
// the first digit in brackets.
std::string marked_decimal(const reference::Rational& approximation,
                           const reference::Rational& exact, int digits);

}  // namespace clipscope::experiments

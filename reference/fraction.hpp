// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact numbers of the reference, and the way back from them to floating point.
//
//   Dyadic    m 2^e, any m and e: what floats, and sums and products of them, are. No gcd is ever
//             taken.
//   Fraction  numerator / denominator of two dyadics: a value whose last operation is a quotient
//   Rational  a canonical rational number, for comparing with other exact computations
//
// Rational gets CGAL's number traits here. CGAL::Exact_rational would be the same
// type here, but its header reads every other exact number that there is, which every source would
// pay for. Source of Dyadic: CGAL::Mpzf (M. Glisse). Each value owns its memory, so values may be
// used by many threads at once, as ints may.
#pragma once

#include <CGAL/Mpzf.h>
#include <CGAL/gmpxx.h>

#include <concepts>

#include "reference/rational.hpp"

#ifndef CGAL_HAS_MPZF
#error "clipscope's reference needs CGAL::Mpzf: GMP 4.3 or newer with 64-bit limbs"
#endif

namespace clipscope::reference {

using Dyadic = CGAL::Mpzf;

// numerator / denominator, not reduced. Invariant: denominator > 0.
struct Fraction {
  Dyadic numerator = 0;
  Dyadic denominator = 1;

  // -1, 0 or 1.
  int sign() const { return static_cast<int>(numerator.sign()); }
};

// Equality of values: 1/2 == 2/4.
bool operator==(const Fraction& a, const Fraction& b);

// Exact. Pre-condition of the double: finite.
Rational to_rational(const Fraction& value);
Rational to_rational(const Dyadic& value);
Rational to_rational(double value);

// The value with a relative error of at most 2^-50; correctly rounded where the result is subnormal
// or too small to be (then 0), or so large that it overflows (then infinite).
double approximate(const Fraction& value);

// The value rounded to float or double, to nearest, ties to even: subnormal results are rounded
// once, and values beyond the largest finite number by half a unit or more become infinite. 0 is
// +0.
template <std::floating_point T>
T round_to(const Fraction& value);
template <>
float round_to<float>(const Fraction& value);
template <>
double round_to<double>(const Fraction& value);
template <std::floating_point T>
T round_to(const Rational& value);
template <>
float round_to<float>(const Rational& value);
template <>
double round_to<double>(const Rational& value);

// value - exact, computed exactly, then rounded with a relative error of at most 2^-50 (one unit in
// the last place where the result is subnormal). 0 where they are equal.
// Pre-condition of the double: finite.
double error_of(double value, const Fraction& exact);
double error_of(const Rational& value, const Fraction& exact);

}  // namespace clipscope::reference

// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/fraction.hpp"

#include <gmp.h>

#include <CGAL/Gmpq.h>

#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

namespace clipscope::reference {
namespace {

// An integer of GMP, freed at the end of its scope.
class Integer {
 public:
  Integer() { mpz_init(value_); }
  ~Integer() { mpz_clear(value_); }
  Integer(const Integer&) = delete;
  Integer& operator=(const Integer&) = delete;
  operator mpz_ptr() { return value_; }  // NOLINT: used like the mpz_t it is

 private:
  mpz_t value_;
};

// k of a denominator 2^k.
long log2_of_power(mpz_srcptr power) { return static_cast<long>(mpz_sizeinbase(power, 2)) - 1; }

// significand 2^exponent <= magnitude < (significand + 1) 2^exponent, with 62 to 64 significant
// bits; the lowest bit also says whether anything was cut off ("sticky").
struct Truncated {
  std::uint64_t significand;
  long exponent;
};

// |numerator / denominator| 2^exponent. Pre-condition: the numerator is not 0, the denominator > 0.
Truncated truncate(mpz_srcptr numerator, mpz_srcptr denominator, long exponent) {
  Integer dividend, divisor, quotient, remainder;
  mpz_abs(dividend, numerator);
  mpz_set(divisor, denominator);

  // Scale so that the integer quotient has 63 or 64 bits.
  const long shift = 63 + static_cast<long>(mpz_sizeinbase(divisor, 2)) -
                     static_cast<long>(mpz_sizeinbase(dividend, 2));
  if (shift >= 0) {
    mpz_mul_2exp(dividend, dividend, shift);
  } else {
    mpz_mul_2exp(divisor, divisor, -shift);
  }

  mpz_tdiv_qr(quotient, remainder, dividend, divisor);
  std::uint64_t significand = mpz_get_ui(quotient);
  if (mpz_sgn(static_cast<mpz_ptr>(remainder)) != 0) significand |= 1;
  return {significand, exponent - shift};
}

// |value|. Pre-condition: value != 0.
Truncated truncate(const Fraction& value) {
  const CGAL::Gmpq a(value.numerator), b(value.denominator);
  const long exponent = log2_of_power(mpq_denref(b.mpq())) - log2_of_power(mpq_denref(a.mpq()));
  return truncate(mpq_numref(a.mpq()), mpq_numref(b.mpq()), exponent);
}
Truncated truncate(const Rational& value) {
  return truncate(value.get_num_mpz_t(), value.get_den_mpz_t(), 0);
}

// Rounds to `digits` significant bits whose last one weighs at least 2^lowest, ties to even. The
// result is exact in double if digits and lowest are those of float or double, or infinite.
double round_half_even(const Truncated& v, int digits, int lowest) {
  int bits = 64;
  while ((v.significand >> (bits - 1)) == 0) --bits;
  const long drop = std::max<long>(bits - digits, lowest - v.exponent);
  if (drop > bits) {
    return 0;  // less than half of the smallest number
  }
  const std::uint64_t kept = drop == 64 ? 0 : v.significand >> drop;
  const std::uint64_t half = std::uint64_t{1} << (drop - 1);
  const std::uint64_t rest = v.significand & (half + (half - 1));
  const bool up = rest > half || (rest == half && (kept & 1) != 0);
  return std::ldexp(static_cast<double>(kept + (up ? 1 : 0)), static_cast<int>(v.exponent + drop));
}

int sign_of(const Fraction& value) { return value.sign(); }
int sign_of(const Rational& value) { return sgn(value); }

// Number: Fraction or Rational.
template <class T, class Number>
T round_exactly(const Number& value) {
  using Limits = std::numeric_limits<T>;
  const int sign = sign_of(value);
  if (sign == 0) return T(0);
  const int lowest = Limits::min_exponent - Limits::digits;  // of the smallest subnormal
  const double magnitude = round_half_even(truncate(value), Limits::digits, lowest);
  if (magnitude > static_cast<double>(Limits::max())) {
    return sign < 0 ? -Limits::infinity() : Limits::infinity();
  }
  return static_cast<T>(sign < 0 ? -magnitude : magnitude);
}

// Whether neither a double's value nor a quotient of two such values can have under- or overflowed.
bool is_moderate(double v) { return 0x1p-500 < std::abs(v) && std::abs(v) < 0x1p500; }

}  // namespace

bool operator==(const Fraction& a, const Fraction& b) {
  return a.numerator * b.denominator == b.numerator * a.denominator;
}

Rational to_rational(const Dyadic& value) { return Rational(CGAL::Gmpq(value).mpq()); }

Rational to_rational(double value) {
  assert(std::isfinite(value));
  return Rational(value);
}

Rational to_rational(const Fraction& value) {
  const Rational numerator = to_rational(value.numerator);
  const Rational denominator = to_rational(value.denominator);
  return Rational(numerator / denominator);
}

// Mpzf::to_double keeps the leading 64 bits or more and rounds: its relative error is below 2^-52.
// The quotient's is then below 2^-52 + 2^-52 + 2^-53 and products of these: below 2^-50.
double approximate(const Fraction& value) {
  const double numerator = value.numerator.to_double();
  const double denominator = value.denominator.to_double();
  if (is_moderate(numerator) && is_moderate(denominator)) return numerator / denominator;
  return round_exactly<double>(value);
}

// The exact value lies between lower and upper, and rounding is monotone: where both round to the
// same float, so does the value. (Below double's normal numbers it does too: there every float is
// 0.)
template <>
float round_to<float>(const Fraction& value) {
  const double estimate = approximate(value);
  const float lower = static_cast<float>(estimate * (1 - 0x1p-49));
  const float upper = static_cast<float>(estimate * (1 + 0x1p-49));
  return lower == upper ? lower : round_exactly<float>(value);
}

template <>
double round_to<double>(const Fraction& value) {
  return round_exactly<double>(value);
}

template <>
float round_to<float>(const Rational& value) {
  return round_exactly<float>(value);
}

template <>
double round_to<double>(const Rational& value) {
  return round_exactly<double>(value);
}

double error_of(double value, const Fraction& exact) {
  assert(std::isfinite(value));
  return approximate({Dyadic(value) * exact.denominator - exact.numerator, exact.denominator});
}

double error_of(const Rational& value, const Fraction& exact) {
  const Rational difference = value - to_rational(exact);
  return round_to<double>(difference);
}

}  // namespace clipscope::reference

// SPDX-License-Identifier: GPL-3.0-or-later
//
// See integer_rounding.hpp.
#include "tests/spaces/attack/integer_rounding.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace clipscope::attack {
namespace {

constexpr int kPrecision = 24, kLowest = -149, kHighest = 127;  // bits, and powers of two of bits

int bits(const Integer& x) { return static_cast<int>(mpz_sizeinbase(x.get_mpz_t(), 2)); }

// |numerator| / denominator / 2^exponent as a whole number, a remainder and what that is a part of.
struct Divided {
  Integer whole, rest, of;
};
Divided divided(const Quotient& q, int exponent) {
  Divided r;
  Integer above = abs(q.numerator);
  r.of = q.denominator;
  if (exponent < 0) {
    above <<= static_cast<mp_bitcnt_t>(-exponent);
  } else {
    r.of <<= static_cast<mp_bitcnt_t>(exponent);
  }
  mpz_fdiv_qr(r.whole.get_mpz_t(), r.rest.get_mpz_t(), above.get_mpz_t(), r.of.get_mpz_t());
  return r;
}

}  // namespace

Integer scaled(float x) {
  const auto word = std::bit_cast<std::uint32_t>(x);
  const std::uint32_t exponent = word >> 23 & 0xFF, fraction = word & 0x7FFFFF;
  Integer r = exponent == 0 ? fraction : fraction | 0x800000;
  if (exponent > 1) r <<= exponent - 1;
  if ((word >> 31) != 0) r = -r;
  return r;
}

Nearest nearest(const Quotient& q) {
  Nearest r;
  r.is_exact = true;
  if (q.numerator == 0) return r;
  // The quotient lies between 2^(size - 1) and 2^(size + 1).
  const int size = bits(q.numerator) - bits(q.denominator);
  int unit = std::max(size - kPrecision, kLowest);  // the last place
  Divided d = divided(q, unit);
  if (bits(d.whole) > kPrecision) d = divided(q, ++unit);
  const Integer beyond_half = 2 * d.rest - d.of;
  const bool is_odd = mpz_odd_p(d.whole.get_mpz_t()) != 0;
  r.is_exact = d.rest == 0;
  r.is_tie = beyond_half == 0;
  r.went_up = beyond_half > 0 || (r.is_tie && is_odd);
  if (!r.is_tie) r.zeros_to_tie = std::max(0, bits(d.of) - bits(beyond_half));
  const auto units = static_cast<std::uint32_t>(d.whole.get_ui() + (r.went_up ? 1 : 0));
  const bool is_infinite = unit > kHighest - kPrecision + 1 ||
                           (unit == kHighest - kPrecision + 1 && units >> kPrecision != 0);
  // At most 2^24 units: both the conversion and the scaling are exact.
  r.value = is_infinite ? std::numeric_limits<float>::infinity()
                        : std::ldexp(static_cast<float>(units), unit);
  if (q.numerator < 0) r.value = -r.value;
  return r;
}

}  // namespace clipscope::attack

// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/fraction.hpp"

#include <cfloat>
#include <cmath>
#include <limits>
#include <random>

#include "tests/catch.hpp"

namespace clipscope::reference {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Fraction fraction(double numerator, double denominator = 1) { return {numerator, denominator}; }

// a + b, exactly.
Fraction sum(double a, double b) { return {Dyadic(a) + Dyadic(b), 1}; }

TEST_CASE("fraction: 1/2 equals 2/4") {
  CHECK(fraction(1, 2) == fraction(2, 4));
  CHECK_FALSE(fraction(1, 2) == fraction(1, 3));
  CHECK(to_rational(fraction(-6, 4)) == Rational(-3) / Rational(2));
  CHECK(to_rational(0x1p-1074) * to_rational(0x1p1023) == to_rational(0x1p-51));
}

TEST_CASE("fraction: thirds are rounded to nearest") {
  CHECK(round_to<double>(fraction(1, 3)) == 1.0 / 3.0);
  CHECK(round_to<float>(fraction(1, 3)) == 1.0f / 3.0f);
  CHECK(round_to<float>(fraction(-2, 3)) == -2.0f / 3.0f);
  CHECK(round_to<double>(fraction(0)) == 0);
}

TEST_CASE("fraction: a tie is rounded to even, and anything off it to its own side") {
  struct Case {
    double tie, down, up;
  };
  const double ulp = 0x1p-52;
  const auto c = GENERATE_COPY(Case{1, 1, 1 + ulp},                   // even below
                               Case{1 + ulp, 1 + ulp, 1 + 2 * ulp});  // even above
  const bool even_is_down = c.down == 1;
  CHECK(round_to<double>(sum(c.tie, ulp / 2)) == (even_is_down ? c.down : c.up));
  const Dyadic tie = Dyadic(c.tie) + Dyadic(ulp / 2), little = 0x1p-900;
  CHECK(round_to<double>({tie + little, 1}) == c.up);
  CHECK(round_to<double>({tie - little, 1}) == c.down);
  CHECK(round_to<double>({-(tie + little), 1}) == -c.up);
}

TEST_CASE("fraction: float ties are rounded to even, not twice") {
  const double tie = 1 + 0x1p-24;  // between 1 and 1 + 2^-23
  CHECK(round_to<float>(fraction(tie)) == 1.0f);
  CHECK(round_to<float>(fraction(1 + 3 * 0x1p-24)) == 1.0f + 0x1p-22f);
  // Rounded to the nearest double first, this would be the tie.
  CHECK(round_to<float>(sum(tie, 0x1p-80)) == 1.0f + 0x1p-23f);
  CHECK(round_to<float>(sum(tie, -0x1p-80)) == 1.0f);
}

TEST_CASE("fraction: subnormal results are rounded once") {
  CHECK(round_to<double>(fraction(0x1p-1074)) == 0x1p-1074);
  CHECK(round_to<double>(fraction(0x1p-1074, 2)) == 0);              // tie with 0
  CHECK(round_to<double>({Dyadic(0x1p-1074) * 3, 2}) == 0x1p-1073);  // tie with 2 units
  CHECK(round_to<double>({Dyadic(0x1p-1074), Dyadic(2) - Dyadic(0x1p-900)}) == 0x1p-1074);
  CHECK(round_to<double>({Dyadic(0x1p-1000) * Dyadic(0x1p-1000), 1}) == 0);
  CHECK(round_to<float>(fraction(0x1p-150)) == 0.0f);
  CHECK(round_to<float>(sum(0x1p-150, 0x1p-210)) == 0x1p-149f);
  CHECK(round_to<float>(fraction(3 * 0x1p-150)) == 0x1p-148f);
  CHECK(round_to<float>(sum(0x1p-126, -0x1p-151)) == 0x1p-126f);
  CHECK(std::signbit(round_to<float>(fraction(-0x1p-300))));
}

TEST_CASE("fraction: half a unit beyond the largest number is infinite, less is not") {
  const double half_ulp = 0x1p970;
  CHECK(round_to<double>(sum(DBL_MAX, half_ulp)) == kInfinity);
  CHECK(round_to<double>(sum(-DBL_MAX, -half_ulp)) == -kInfinity);
  CHECK(round_to<double>({Dyadic(DBL_MAX) + Dyadic(half_ulp) - 1, 1}) == DBL_MAX);
  CHECK(round_to<float>(sum(FLT_MAX, 0x1p103)) == std::numeric_limits<float>::infinity());
  CHECK(round_to<float>({Dyadic(FLT_MAX) + Dyadic(0x1p103) - Dyadic(0x1p-80), 1}) == FLT_MAX);
  CHECK(round_to<double>({Dyadic(DBL_MAX) * Dyadic(DBL_MAX), 1}) == kInfinity);
  CHECK(round_to<double>({Dyadic(DBL_MAX), Dyadic(0x1p-1074)}) == kInfinity);
}

// The processor's division of two doubles is correctly rounded: an independent witness.
TEST_CASE("fraction: rounding agrees with the processor's division") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> significand(-2, 2);
  const int range = GENERATE(3, 100, 1030);
  std::uniform_int_distribution<int> exponent(-range, range);
  for (int i = 0; i < 20000; ++i) {
    const double a = std::ldexp(significand(random), std::min(exponent(random), 1020));
    const double b = std::ldexp(std::abs(significand(random)), std::min(exponent(random), 1020));
    if (b == 0) continue;
    const double quotient = a / b;
    CAPTURE(a, b);
    REQUIRE(round_to<double>(fraction(a, b)) == quotient);
    const float fa = static_cast<float>(a), fb = static_cast<float>(b);
    if (fb != 0 && std::isfinite(fa) && std::isfinite(fb)) {
      REQUIRE(round_to<float>(fraction(fa, fb)) == fa / fb);
    }
    if (std::isnormal(quotient)) {
      REQUIRE(std::abs(error_of(approximate(fraction(a, b)), fraction(a, b))) <=
              std::abs(quotient) * 0x1p-50);
    }
  }
}

template <class T>
bool is_even(T x) {
  using Limits = std::numeric_limits<T>;
  if (x == 0) return true;
  const int ulp =
      std::max(std::ilogb(x) - Limits::digits + 1, Limits::min_exponent - Limits::digits);
  return std::fmod(std::ldexp(x, -ulp), T(2)) == 0;
}

// No double is nearer than the one found: neither neighbour, and of two that are as near the even
// one. The neighbours are compared in rationals, so that nothing here is rounded.
template <class T>
void check_nearest(const Rational& exact) {
  const T found = round_to<T>(exact);
  CAPTURE(found);
  REQUIRE(std::isfinite(found));
  const auto distance = [&](T x) { return Rational(abs(Rational(Rational(x) - exact))); };
  const Rational own = distance(found);
  for (const T direction :
       {-std::numeric_limits<T>::infinity(), std::numeric_limits<T>::infinity()}) {
    const T neighbour = std::nextafter(found, direction);
    if (!std::isfinite(neighbour)) continue;
    const Rational other = distance(neighbour);
    REQUIRE(own <= other);
    if (own == other) REQUIRE(is_even(found));
  }
}

TEST_CASE("fraction: no neighbour is nearer to a rational than what it is rounded to") {
  std::mt19937_64 random(9);
  std::uniform_int_distribution<int> integer(-4000, 4000), exponent(-140, 120);
  for (int i = 0; i < 5000; ++i) {
    Rational value(integer(random), 2 * std::abs(integer(random)) + 1);
    value.canonicalize();
    value *= Rational(std::ldexp(1.0, exponent(random)));
    CAPTURE(value.get_str());
    check_nearest<double>(value);
    check_nearest<float>(value);
    check_nearest<double>(Rational(value * Rational(0x1p-1000)));  // subnormal in part
  }
}

TEST_CASE("fraction: 1/10 is the double 0.1, and a tie of rationals goes to even") {
  CHECK(round_to<double>(Rational(1, 10)) == 0.1);
  CHECK(round_to<float>(Rational(-1, 10)) == -0.1f);
  CHECK(round_to<double>(Rational(Rational(1) + Rational(0x1p-53))) == 1);
  CHECK(round_to<double>(Rational(Rational(1) + 3 * Rational(0x1p-53))) == 1 + 0x1p-51);
  CHECK(round_to<double>(Rational(0)) == 0);
  CHECK(round_to<double>(Rational(Rational(DBL_MAX) + Rational(0x1p970))) == kInfinity);
  CHECK(round_to<double>(Rational(Rational(0x1p-1074) / 2)) == 0);
}

// Many limbs, so that Mpzf::to_double cuts.
TEST_CASE("fraction: an approximation of long numbers is within 2^-50") {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::uniform_int_distribution<int> exponent(-150, 150);
  const auto number = [&] {
    Dyadic r = 1;
    for (int i = 0; i < 4; ++i) {
      r *= Dyadic(std::ldexp(uniform(random), exponent(random))) + Dyadic(uniform(random));
    }
    return r;
  };
  for (int i = 0; i < 20000; ++i) {
    const Dyadic denominator = number();
    const Fraction f = {number(), denominator * denominator};
    const double rounded = round_to<double>(f);
    REQUIRE(std::abs(approximate(f) - rounded) <= std::abs(rounded) * 0x1p-50);
    const double error = error_of(rounded, f);
    REQUIRE(std::abs(error) <= std::abs(rounded) * 0x1p-53);
  }
}

TEST_CASE("fraction: an error is exact to the last bit that a double can hold") {
  CHECK(error_of(0.5, fraction(1, 2)) == 0);
  CHECK(error_of(1.0, sum(1, 0x1p-900)) == -0x1p-900);
  CHECK(error_of(1.0 / 3.0, fraction(1, 3)) == Approx(-0x1p-54 / 3).epsilon(1e-14));
  CHECK(error_of(DBL_MAX, fraction(-DBL_MAX)) == kInfinity);
  CHECK(error_of(0x1p-1074, fraction(0)) == 0x1p-1074);
  const Rational third = Rational(1) / Rational(3);
  CHECK(error_of(third, fraction(1, 3)) == 0);
  CHECK(error_of(third, fraction(1, 2)) == Approx(-1.0 / 6).epsilon(1e-15));
}

}  // namespace
}  // namespace clipscope::reference

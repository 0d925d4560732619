// SPDX-License-Identifier: GPL-3.0-or-later
//
// Expansions against rational numbers, and the rounding of their quotients at the ends of the
// floats.
#include "spaces/expansion.hpp"

#include <limits>

#include "reference/fraction.hpp"
#include "spaces/barycentric/exact_lines.hpp"
#include "tests/catch.hpp"
#include "tests/spaces/volumes.hpp"

namespace clipscope::reference {
namespace {

using barycentric::CountStages;
using barycentric::ExactDot;
using barycentric::Stage;

template <int N>
Rational exact_value(const Expansion<N>& e) {
  Rational r(0);
  for (const double c : e) r += to_rational(c);
  return r;
}

// Two components or fewer, sometimes 0, with gaps between the two of up to 150 bits.
Expansion<2> random_pair(Random& random) {
  if (random() % 16 == 0) return {};
  const double head = over_magnitudes<float>(random, -38, 38);
  const double tail = random() % 4 == 0 ? 0 : over_magnitudes<float>(random, -44, 38);
  const auto [sum, error] = bounds::two_sum(head, tail);
  return {sum, error};
}

template <int N>
bool is_ordered_without_overlap(const Expansion<N>& e) {
  for (int i = 0; i + 1 < e.size(); ++i) {
    int exponent = 0;  // e[i] < 2^exponent, of which e[i + 1] has to be a multiple
    std::frexp(e[i], &exponent);
    if (std::abs(e[i]) >= std::abs(e[i + 1])) return false;
    const double scaled = std::ldexp(e[i + 1], -exponent);
    if (std::abs(scaled) < 0x1p52 && scaled != std::nearbyint(scaled)) return false;
  }
  return true;
}

TEST_CASE("expansion: sums and products are exact, and their components do not overlap") {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Expansion<2> a = random_pair(random), b = random_pair(random), c = random_pair(random),
                       d = random_pair(random);
    const Rational x = exact_value(a), y = exact_value(b), z = exact_value(c), t = exact_value(d);
    const auto minor = a * b - c * d;
    const Rational exact_minor(x * y - z * t);
    REQUIRE(exact_value(minor) == exact_minor);
    REQUIRE(minor.sign() == sgn(exact_minor));
    REQUIRE(is_ordered_without_overlap(minor));
    const auto cubic = minor * a - minor;
    REQUIRE(exact_value(cubic) == Rational(exact_minor * x - exact_minor));
    REQUIRE(is_ordered_without_overlap(cubic));
    const Expansion<18> few = compressed<18>(cubic);
    REQUIRE(exact_value(few) == exact_value(cubic));
    REQUIRE(few.size() <= 18);
    REQUIRE(is_ordered_without_overlap(few));
    const Rational rest(exact_value(few) - to_rational(few.largest()));
    REQUIRE(abs(rest) <= abs(Rational(to_rational(few.largest()) * to_rational(0x1p-52))));
  }
}

TEST_CASE("expansion: what cancels is zero") {
  const Expansion<2> a(1, 0x1p-80), b(-3, 0x1p-70);
  CHECK((a * b - b * a).sign() == 0);
  CHECK((a * b - b * a).size() == 0);
  CHECK((a - Expansion<2>(1, 0)).sign() == 1);
  CHECK((a * 0.0).size() == 0);
}

constexpr float kLargest = std::numeric_limits<float>::max();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kSmallest = std::numeric_limits<float>::denorm_min();

float rounded(double head, double tail, CountStages& count) {
  return barycentric::round_quotient(ExactDot(head, tail), ExactDot(1, 0), count);
}

TEST_CASE("correctly rounded: half a unit above the largest float rounds to infinity") {
  const double half_above = 0x1.ffffffp127, tiny = 0x1p-60;
  CountStages count;
  CHECK(rounded(half_above, 0, count) == kInfinity);
  CHECK(rounded(half_above, tiny, count) == kInfinity);
  CHECK(rounded(half_above, -tiny, count) == kLargest);
  CHECK(rounded(-half_above, 0, count) == -kInfinity);
  CHECK(rounded(-half_above, tiny, count) == -kLargest);
  CHECK(count[Stage::quotient_tie] == 2);
  CHECK(count[Stage::quotient_midpoint] == 3);
}

TEST_CASE("correctly rounded: half of the smallest float rounds to zero, with its sign") {
  const double half = 0x1p-150, tiny = 0x1p-250;
  CountStages count;
  CHECK(rounded(half, tiny, count) == kSmallest);
  CHECK(rounded(half, 0, count) == 0);
  CHECK(rounded(3 * half, 0, count) == 2 * kSmallest);
  CHECK(rounded(-half, -tiny, count) == -kSmallest);
  CHECK(std::signbit(rounded(-half, 0, count)));
  CHECK(!std::signbit(rounded(0, 0, count)));
  CHECK(count[Stage::quotient_tie] == 3);
}

}  // namespace
}  // namespace clipscope::reference

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/worst_cases/near_tie.hpp"

#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::worst_cases;
using reference::Dyadic;
using reference::Fraction;

namespace {

Fraction fraction(double numerator, double denominator) {
  return {Dyadic(numerator), Dyadic(denominator)};
}

// a, b and c in clip space; the edge a b crosses x = w in the middle.
HardCase half_and_half(float y_a, float y_b) {
  HardCase c;
  c.vertices.resize(3);
  c.vertices[0].position = {0, y_a, 0, 1};
  c.vertices[1].position = {2, y_b, 0, 1};
  c.vertices[2].position = {0, -1, 0, 1};
  return marked(c);
}

}  // namespace

TEST_CASE("near tie: the distance is that to the middle of two floats, in their distance") {
  CHECK(distance_to_tie(fraction(1 + 0x1p-24, 1)) == 0.0);
  CHECK(distance_to_tie(fraction(1 - 0x1p-25, 1)) == 0.0);
  CHECK(distance_to_tie(fraction(1 + 0x1p-24 + 0x1p-30, 1)) == 0x1p-7);
  CHECK(distance_to_tie(fraction(1 + 0x1p-26, 1)) == 0.375);
  CHECK(distance_to_tie(fraction(-1 - 0x1p-24 - 0x1p-40, 1)) == 0x1p-17);
}

TEST_CASE("near tie: below 1 an ulp is half of that above") {
  CHECK(distance_to_tie(fraction(1 - 0x1p-26, 1)) == 0.25);
}

TEST_CASE("near tie: subnormal floats have ties too") {
  CHECK(distance_to_tie(fraction(0x1.8p-149, 1)) == 0.0);
  CHECK(distance_to_tie(fraction(0x1p-150, 1)) == 0.0);
  CHECK(distance_to_tie(fraction(0x1.4p-149, 1)) == 0.25);
}

TEST_CASE("near tie: a float and what rounds to infinity have no distance") {
  CHECK_FALSE(distance_to_tie(fraction(0, 1)));
  CHECK_FALSE(distance_to_tie(fraction(0.75, 1)));
  CHECK_FALSE(distance_to_tie(fraction(0x1p128, 1)));
}

TEST_CASE("near tie: what is too near for a double is no tie") {
  const Dyadic tiny = Dyadic(0x1p-1000) * Dyadic(0x1p-1000);
  const std::optional<double> distance = distance_to_tie({Dyadic(1 + 0x1p-24) + tiny, 1});
  REQUIRE(distance);
  CHECK(*distance > 0);
}

TEST_CASE("near tie: a number counts where it comes from") {
  // y = (y_a + y_b) / 2 on the edge a b, a tie.
  const HardCase c = half_and_half(0.5f, 0.5f + 0x1p-24f);
  const reference::ExactPolygon polygon = exact_polygon(c);
  const TieTally edge = tie_tally({Space::clip, Place::edge, Quantity::xy}, polygon);
  CHECK(edge.ties == 1);
  CHECK_FALSE(edge.nearest_ulp);
  CHECK(tie_tally({Space::clip, Place::vertex, Quantity::xy}, polygon).numbers == 0);
  CHECK(tie_tally({Space::clip, Place::corner, Quantity::xy}, polygon).numbers == 0);
}

TEST_CASE("near tie: a tally keeps the nearest that is no tie") {
  TieTally tally{2, 1, 0.25};
  tally += {3, 0, 0.125};
  tally += {1, 1, {}};
  CHECK(tally.numbers == 6);
  CHECK(tally.ties == 2);
  CHECK(tally.nearest_ulp == 0.125);
}

TEST_CASE("near tie: one exponent means 24 bits for all coordinates together") {
  CHECK(has_one_exponent(half_and_half(0.5f, 0.25f)));
  CHECK(has_one_exponent(half_and_half(0x1p-22f, 0.25f)));
  CHECK_FALSE(has_one_exponent(half_and_half(0x1p-23f, 0.25f)));
}

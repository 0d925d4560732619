// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/worst_cases/constructed.hpp"

#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::worst_cases;

namespace {

constexpr std::size_t kAttempts = 4000;

TieTally tally_of(const TieKind& kind, const HardCase& c) {
  return tie_tally(kind, exact_polygon(c));
}

}  // namespace

TEST_CASE("constructed: every kind comes within a few times its bound, with one exponent") {
  for (const TieKind& kind : all_tie_kinds()) {
    CAPTURE(name_of(kind));
    Random random(1);
    const std::optional<HardCase> c = constructed(kind, Aim::near_tie, kAttempts, random);
    REQUIRE(c);
    CHECK(has_one_exponent(*c));
    const TieTally tally = tally_of(kind, *c);
    REQUIRE(tally.nearest_ulp);
    CAPTURE(*tally.nearest_ulp / least_distance_ulp(kind));
    CHECK(*tally.nearest_ulp >= least_distance_ulp(kind));
    CHECK(*tally.nearest_ulp <= 16 * least_distance_ulp(kind));
  }
}

TEST_CASE("constructed: quotients of the triangle and of its edges reach the bound itself") {
  for (const TieKind& kind : all_tie_kinds()) {
    const bool is_inverse = kind.quantity == Quantity::inv_w ||
                            (kind.quantity == Quantity::z && kind.space == Space::view);
    if (kind.place == Place::corner || (kind.place == Place::edge && is_inverse)) continue;
    CAPTURE(name_of(kind));
    Random random(1);
    const std::optional<HardCase> c = constructed(kind, Aim::near_tie, 10, random);
    REQUIRE(c);
    CHECK(tally_of(kind, *c).nearest_ulp == Approx(least_distance_ulp(kind)).epsilon(0x1p-48));
  }
}

TEST_CASE("constructed: every kind but quotients of two floats has an exact tie") {
  for (const TieKind& kind : all_tie_kinds()) {
    if (!has_ties(kind.place)) continue;
    CAPTURE(name_of(kind));
    Random random(1);
    const std::optional<HardCase> c = constructed(kind, Aim::tie, kAttempts, random);
    REQUIRE(c);
    CHECK(tally_of(kind, *c).ties > 0);
    CHECK(has_one_exponent(*c));
  }
}

TEST_CASE("constructed: the same seed makes the same") {
  const TieKind kind{Space::clip, Place::corner, Quantity::z};
  Random one(3), two(3);
  CHECK(constructed(kind, Aim::near_tie, 500, one)->vertices[2].position ==
        constructed(kind, Aim::near_tie, 500, two)->vertices[2].position);
}

TEST_CASE("constructed: beside a tie of distant exponents is nearer than any hundred bits") {
  for (const TieKind& kind : all_tie_kinds()) {
    if (!has_ties(kind.place)) continue;
    CAPTURE(name_of(kind));
    const TieTally tally = tally_of(kind, beside_a_tie(kind));
    REQUIRE(tally.nearest_ulp);
    CHECK(*tally.nearest_ulp < 0x1p-100);
  }
}

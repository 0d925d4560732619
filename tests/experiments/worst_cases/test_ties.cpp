// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/worst_cases/ties.hpp"

#include "experiments/catalogue/catalogue.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::worst_cases;

namespace {

constexpr TieKind kEdge = {Space::clip, Place::edge, Quantity::xy};

}  // namespace

TEST_CASE("ties: a search finds a record, keeps it, and finds the same again") {
  const Search search{.seed = 1, .sample = 400};
  for (const TieRecord which : {TieRecord::one_exponent, TieRecord::tie}) {
    const TieResult found = searched(kEdge, which, nullptr, search);
    CAPTURE(name_of(kEdge, which));
    REQUIRE(found.nearest);
    CHECK(found.standing == Standing::added);
    CHECK(figure_of(kEdge, which, found.nearest->hard_case) == found.nearest->figure);
    CHECK(is_rounded_right(found.nearest->hard_case));
    const TieResult kept = searched(kEdge, which, &*found.nearest, search);
    CHECK(kept.standing == Standing::kept);
    CHECK(case_text(kept.nearest->hard_case) == case_text(found.nearest->hard_case));
  }
}

TEST_CASE("ties: with any exponents a search comes nearer than one exponent allows") {
  for (const TieKind& kind : all_tie_kinds()) {
    if (!has_ties(kind.place)) continue;
    CAPTURE(name_of(kind));
    const TieResult any =
        searched(kind, TieRecord::any_exponents, nullptr, {.seed = 1, .sample = 64});
    REQUIRE(any.nearest);
    CHECK(any.nearest->figure > 0);
    CHECK(any.nearest->figure < least_distance_ulp(kind));
    CHECK_FALSE(has_one_exponent(any.nearest->hard_case));
    CHECK(is_rounded_right(any.nearest->hard_case));
  }
}

TEST_CASE("ties: chance is as the model of uniform distances expects") {
  const std::vector<TieTally> tallies = tallies_of_chance({.seed = 1, .sample = 2000});
  const std::vector<TieKind> kinds = all_tie_kinds();
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    CAPTURE(name_of(kinds[i]), tallies[i].numbers);
    REQUIRE(tallies[i].numbers > 100);
    const double expected = expected_nearest_ulp(tallies[i].numbers);
    // Chances of less than 1/1000 on either side: exp(-12), and 1 - exp(-0.0005).
    CHECK(*tallies[i].nearest_ulp < 12 * expected);
    CHECK(*tallies[i].nearest_ulp > 0.0005 * expected);
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/worst_cases/diophantine.hpp"

#include <algorithm>

#include "tests/catch.hpp"

using namespace clipscope::experiments::worst_cases;

namespace {

bool is_small(const Ints& v) {
  return std::ranges::all_of(v, [](const Int& x) { return abs(x) <= 20; });
}

}  // namespace

TEST_CASE("diophantine: weights are orthogonal to their rows, or there are none") {
  const auto weights = weights_of({{2, -1, 0}, {0, 2, -1}});
  REQUIRE(weights);
  CHECK(weights->values == Ints{1, 2, 4});
  CHECK(weights->sum() == 7);
  CHECK(weights_of({{5, -3}})->values == Ints{3, 5});
  CHECK_FALSE(weights_of({{5, 3}}));
}

TEST_CASE("diophantine: a solution has the weighted sum and lies next to the target") {
  const auto weights = weights_of({{1001, -17, 5}, {3, 900, -2000}});
  REQUIRE(weights);
  // Ten times the weights' sum is that of (10, 10, 10).
  const Int value = 10 * weights->sum() + 1;
  const Target target{Ints(3, value), weights->sum()};
  const auto v = solution(*weights, value, target, [](const Ints&) { return true; });
  REQUIRE(v);
  CHECK(dot(weights->values, *v) == value);
  // Half of both rows at most, for they are next to orthogonal.
  CHECK(std::ranges::all_of(*v, [](const Int& x) { return abs(x) <= 1500; }));
}

TEST_CASE("diophantine: there is no solution where the divisor of the weights does not fit") {
  const auto weights = weights_of({{4, -2}});
  const Target target{{8, 8}, 6};
  CHECK_FALSE(solution(*weights, 7, target, is_small));
  CHECK(solution(*weights, 8, target, is_small));
}

TEST_CASE("diophantine: quotients are rounded to the nearest whole number") {
  CHECK(rounded_quotient(7, 3) == 2);
  CHECK(rounded_quotient(8, 3) == 3);
  CHECK(rounded_quotient(-7, 3) == -2);
  CHECK(rounded_quotient(-8, 3) == -3);
  CHECK(modulo(-1, 5) == 4);
  CHECK(inverse(3, 7) == Int(5));
  CHECK_FALSE(inverse(2, 8));
}

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The policy of "the same polygon": zeros, NaN, repeats, the first vertex.
#include <array>
#include <limits>
#include <vector>

#include "experiments/judge/cycle.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;

namespace {

using Vertex = std::array<float, 2>;
using Polygon = std::vector<Vertex>;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr Vertex a{0, 0}, b{1, 0}, c{1, 1}, d{0, 1};

bool same(const Polygon& x, const Polygon& y, Likeness likeness = Likeness::by_value) {
  return same_cycle(x, y, likeness);
}

}  // namespace

TEST_CASE("cycle: whichever vertex is first, in the same winding only") {
  CHECK(same({a, b, c, d}, {c, d, a, b}));
  CHECK_FALSE(same({a, b, c, d}, {d, c, b, a}));
  CHECK_FALSE(same({a, b, c, d}, {a, b, c}));
  CHECK(same({}, {}));
  CHECK_FALSE(same({}, {a}));
}

TEST_CASE("cycle: by value -0 is 0, by bits it is not") {
  const Polygon negative = {{-0.0f, 0}, b, c};
  CHECK(same({a, b, c}, negative));
  CHECK_FALSE(same({a, b, c}, negative, Likeness::by_bits));
}

TEST_CASE("cycle: a NaN is the same as a NaN; by bits its sign counts") {
  CHECK(same({{kNaN, 0}, b, c}, {{-kNaN, 0}, b, c}));
  CHECK(same({{kNaN, 0}, b, c}, {{kNaN, 0}, b, c}, Likeness::by_bits));
  CHECK_FALSE(same({{kNaN, 0}, b, c}, {{-kNaN, 0}, b, c}, Likeness::by_bits));
  CHECK_FALSE(same({{kNaN, 0}, b, c}, {a, b, c}));
}

TEST_CASE("cycle: repeats count, and can be taken out, the last before the first too") {
  CHECK_FALSE(same({a, b, b, c}, {a, b, c}));
  const Polygon repeated = {a, b, b, b, c, a, a};
  CHECK(without_repeats(repeated, Likeness::by_value) == Polygon{a, b, c});
  CHECK(without_repeats(Polygon{a, a, a}, Likeness::by_value) == Polygon{a});
  CHECK(without_repeats(Polygon{}, Likeness::by_value).empty());
  CHECK(without_repeats(Polygon{a, {-0.0f, 0}, b}, Likeness::by_bits).size() == 3);
}

TEST_CASE("cycle: numbers wider than a double are compared to the end") {
  const Number high{1, 0x1p-80}, other{1, 0x1p-81};
  CHECK(same_number(high, high, Likeness::by_value));
  CHECK_FALSE(same_number(high, other, Likeness::by_value));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/contestants/answers.hpp"

#include <random>

#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

// Of the whole and of what it leaves, no neighbour may be nearer.
bool is_nearest(double x, const Exact& exact) {
  const auto distance = [&](double y) { return Exact(abs(Exact(Exact(y) - exact))); };
  return distance(x) <= distance(std::nextafter(x, -1e300)) &&
         distance(x) <= distance(std::nextafter(x, 1e300));
}

TEST_CASE("answers: an exact number is kept, beside the nearest double") {
  Answers answers(kFormat<Exact>, 1);
  const Exact tenth(1, 10);
  answers.add(tenth);
  answers.end_polygon();
  const Number x = answers[0][0][0];
  CHECK(x.value == 0.1);
  CHECK(to_exact(x) == tenth);
}

TEST_CASE("answers: a rational becomes a double-double whose two parts are each the nearest") {
  std::mt19937_64 random(3);
  std::uniform_int_distribution<int> integer(-100000, 100000);
  for (int i = 0; i < 5000; ++i) {
    Exact value(integer(random), 2 * std::abs(integer(random)) + 1);
    value.canonicalize();
    CAPTURE(value.get_str());
    const dd_real found = nearest_double_double(value);
    REQUIRE(is_nearest(found.x[0], value));
    REQUIRE(is_nearest(found.x[1], Exact(value - Exact(found.x[0]))));
  }
}

TEST_CASE("answers: of a double-double the value is the nearest double, and nothing is lost") {
  Answers answers(kFormat<dd_real>, 1);
  const dd_real parts(1, 0x1.8p-52);  // not QD's normal form: the second is beyond half an ulp
  answers.add(parts);
  answers.end_polygon();
  const Number x = answers[0][0][0];
  CHECK(x.value == 1 + 0x1p-51);
  CHECK(to_exact(x) == to_exact(parts));
}

}  // namespace
}  // namespace clipscope::experiments

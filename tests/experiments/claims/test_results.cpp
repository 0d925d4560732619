// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/results.hpp"

#include "tests/catch.hpp"
#include "tests/experiments/claims/fabricated.hpp"

using namespace clipscope::experiments;

namespace {

Results two_rows() {
  return results_from({{"t", "clipper;scalar;ns\na;float;1.5\nb;float;-\nb;double;7\n"}});
}

}  // namespace

TEST_CASE("results: a figure is found by what its row says") {
  CHECK(two_rows().number("t", "ns", {{"clipper", "a"}}) == 1.5);
  CHECK(two_rows().number("t", "ns", {{"clipper", "b"}, {"scalar", "double"}}) == 7);
}

TEST_CASE("results: empty cells are no figures") {
  CHECK(two_rows().numbers("t", "ns", {{"clipper", "b"}}) == std::vector<double>{7});
  CHECK_THROWS_AS(two_rows().number("t", "ns", {{"clipper", "b"}, {"scalar", "float"}}),
                  MissingFigure);
}

TEST_CASE("results: what is missing is named") {
  CHECK_THROWS_WITH(two_rows().number("u", "ns", {}), Catch::Contains("table u"));
  CHECK_THROWS_WITH(two_rows().number("t", "px", {}), Catch::Contains("no column px"));
  CHECK_THROWS_WITH(two_rows().number("t", "ns", {{"clipper", "c"}}), Catch::Contains("clipper=c"));
}

TEST_CASE("results: texts are distinct and in order") {
  CHECK(two_rows().texts("t", "clipper") == std::vector<std::string>{"a", "b"});
  CHECK(two_rows().texts("t", "scalar", {{"clipper", "b"}}) ==
        std::vector<std::string>{"float", "double"});
}

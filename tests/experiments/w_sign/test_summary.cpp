// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/w_sign/rows.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;
using namespace clipscope::experiments::w_sign;

namespace {

EpsilonRow wall(double scale, std::optional<double> epsilon, double lost_percent) {
  EpsilonRow row{"wall", "near plane", scale, scale / 100, epsilon ? "with" : "without", epsilon,
                 {}};
  row.loss.lost_percent = lost_percent;
  return row;
}

PreventedRow prevented(const std::string& input, std::int64_t zero_w) {
  PreventedRow row;
  row.input = input;
  row.clipper = "homogeneous/sutherland_hodgman";
  row.hazards = {.triangles = 100, .zero_w = zero_w};
  return row;
}

}  // namespace

TEST_CASE("w_sign: the plot has a line for each epsilon that loses something") {
  const Plot plot = loss_plot({wall(1, std::nullopt, 50), wall(1, 0.0, 0), wall(1, 1e-5, 0),
                               wall(1e-5, 0.0, 0), wall(1e-5, 1e-5, 70)});
  REQUIRE(plot.series.size() == 1);
  CHECK(plot.series[0].name == "w >= 1e-05, near plane");
  CHECK(plot.series[0].x == std::vector{1.0, 1e-5});
  CHECK(plot.series[0].y == std::vector{0.0, 70.0});
}

TEST_CASE("w_sign: the finding follows the rows") {
  const std::string text = finding({{"- - -", "homogeneous/sutherland_hodgman", "float", 40, 3},
                                    {"- - -", "cvv/naive", "float", 40, 9}},
                                   {wall(1, 1e-5, 0.5), wall(0.1, 1e-5, 20), wall(0.01, 1e-5, 90)},
                                   {prevented("patterns", 7), prevented("floor", 0)});
  INFO(text);
  CHECK_THAT(
      text,
      Catch::Contains(
          "of 40 random triangles with every sign of w float clip space fails on 3, clipping after the divide on 9"));
  CHECK_THAT(text, Catch::Contains("without a w-plane 0 of 100 triangles of scenes"));
  CHECK_THAT(
      text,
      Catch::Contains(
          "and 7 of the random ones; with loses 20 % of a visible wall in a scene of 0.1 m (near plane)."));
}

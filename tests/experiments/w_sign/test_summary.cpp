// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/table/prose.hpp"
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
  std::vector<PatternRow> patterns = {{"- - -", "homogeneous/sutherland_hodgman", "float", 40, 3},
                                      {"- - -", "cvv/naive", "float", 40, 9}};
  std::vector<PreventedRow> scenes = {prevented("patterns", 7), prevented("floor", 0)};
  const auto checked = [&](const std::vector<EpsilonRow>& epsilon) {
    const std::string text = finding(patterns, epsilon, scenes);
    INFO(text);
    CHECK(faults_of_prose(text).empty());
    return text;
  };
  CHECK(
      checked({wall(1, 1e-5, 0.5), wall(0.01, 1e-5, 90)}) ==
      "Scenes need no plane in front of the six in clip space: none of 100 clipped triangles leaves a division by zero, by a negative w or an overflow. A plane w >= epsilon cuts away most of what is visible where lengths come near epsilon. On random triangles with every sign of w dividing first is wrong 3 times as often as clip space in float.");
  patterns[1].failures = 2;
  scenes[1] = prevented("floor", 4);
  CHECK(
      checked({wall(1, 1e-5, 0.5)}) ==
      "Scenes need a plane in front of the six in clip space: 4 clipped triangles leave a division by zero, by a negative w or an overflow. A plane w >= epsilon cut away nothing visible at any scale. On random triangles with every sign of w dividing first is wrong less often than clip space in float.");
}

TEST_CASE("w_sign: the finding does without clippers that were not asked for") {
  CHECK(finding({}, {}, {}) == "No scene was clipped in clip space by the six planes alone.");
}

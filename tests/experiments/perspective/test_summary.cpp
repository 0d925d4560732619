// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is said of perspective correction, on rows made by hand.
#include "experiments/perspective/rows.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments::perspective {
namespace {

Tables tables() {
  Tables t;
  t.ratios.add({.ratio = 4, .bound = 0.25, .attained = true});
  t.ratios.add({.ratio = 9, .bound = 0.5, .beyond = 2});
  t.thresholds.add({.criterion = "half a texel", .texels = 256, .error = 0.125, .ratio = 1.5});
  t.thresholds.add(
      {.criterion = "half a level, ramp", .texels = 256, .error = 0.125, .ratio = 1.5});
  t.scenes.add({.scene = "near", .above_1024 = 20});
  t.scenes.add({.scene = "far", .above_1024 = 2});
  for (const char* scalar : {"float", "double"}) {
    t.cuts.add({.ratio = 4, .clipper = "cvv/naive", .scalar = scalar, .max_error = 0.25});
  }
  return t;
}

}  // namespace

TEST_CASE("perspective: rows read back as they were written") {
  const std::vector<RatioRow> ratios = tables().ratios.rows();
  CHECK(ratios[0].attained);
  CHECK_FALSE(ratios[1].attained);
  CHECK(ratios[1].beyond == 2);
  CHECK(ratios[1].above_one() == 8);
  CHECK(ratios[1].texels_1024() == 512);
}

TEST_CASE("perspective: the finding names what was attained, the thresholds and the extremes") {
  Tables t = tables();
  CHECK(
      finding(t) ==
      "Without perspective correction an attribute is off by up to (sqrt(r) - 1) / (sqrt(r) + 1) of its range, r = w_max/w_min: attained exactly at 1 of 2 ratios, passed at 2 points. Half a texel is passed at r = 1.5 (256 texels). With 1024 texels per unit 20 % of the visible triangles of near are off by more, and 2 % of far.");
  t.cuts.add({.ratio = 4, .clipper = "cvv/perspective", .scalar = "float", .max_error = 1e-7});
  CHECK(finding(t).ends_with("unless it is corrected: up to 0.25 against 1e-07."));
}

TEST_CASE("perspective: the plot has a line per error, the search, and clippers in float") {
  const Plot plot = error_plot(tables());
  std::vector<std::string> names;
  for (const Series& series : plot.series) names.push_back(series.name);
  CHECK(names == std::vector<std::string>{"", "bound (sqrt(r) - 1) / (sqrt(r) + 1)",
                                          "measured on the edge", "measured inside triangles",
                                          "cvv/naive, float"});
  CHECK(plot.series[0].labels[1] == "half a texel, 256 texels");
  CHECK(plot.series.back().x == std::vector<double>{3});
}

}  // namespace clipscope::experiments::perspective

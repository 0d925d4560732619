// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is said of perspective correction, on rows made by hand.
#include "experiments/perspective/rows.hpp"
#include "experiments/table/prose.hpp"
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

TEST_CASE("perspective: the finding follows the rows") {
  const auto checked = [](const Tables& t) {
    const std::string text = finding(t);
    INFO(text);
    CHECK(faults_of_prose(text).empty());
    return text;
  };
  Tables t = tables();
  CHECK(
      checked(t) ==
      "The bound of the error without perspective correction does not hold: it is attained exactly at most ratios of w that were tried, and passed at some points. In a texture of 256 texels it reaches half a texel as soon as w varies by a factor of 1.5 along an edge. With such a texture few visible parts call for correction on near, and few on far.");
  t.cuts.add({.ratio = 4, .clipper = "cvv/perspective", .scalar = "float", .max_error = 1e-7});
  CHECK(
      checked(t).ends_with("carries the same error into new vertices unless it corrects for it."));
  t.cuts.add({.ratio = 4, .clipper = "cvv/perspective", .scalar = "float", .max_error = 0.25});
  CHECK(checked(t).ends_with("adds no such error to new vertices, corrected or not."));
}

TEST_CASE("perspective: a bound that is attained everywhere and passed nowhere is sharp") {
  Tables t;
  t.ratios.add({.ratio = 4, .attained = true});
  CHECK(finding(t).starts_with("The bound of the error without perspective correction is sharp"));
  CHECK(finding({}) == "No error without perspective correction was measured.");
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/bounds/rows.hpp"

#include <cmath>

#include "tests/catch.hpp"

using namespace clipscope::experiments;
using namespace clipscope::experiments::bounds;

namespace {

Row row(const std::string& scene, const std::string& bound, double closer, double speedup,
        const std::string& clipper = "one") {
  Row r{.scene = scene,
        .object = "pot",
        .bound = bound,
        .closer_percent = closer,
        .settleable_percent = 90,
        .untouched_percent = closer / 2,
        .polygons = std::string(kSame),
        .judged_triangles = 100,
        .visible_lost = 1,
        .accepted_cut = 2,
        .clipper = clipper};
  r.speedup = {speedup, speedup - 1, speedup + 1};
  return r;
}

std::vector<Row> rows() {
  std::vector<Row> rows = {row("a", "box", 40, 2), row("a", "sphere", 10, 3),
                           row("b", "box", 80, 0.5), row("b", "box", 20, 9, "another")};
  rows.push_back(row("b", "sphere", 60, 1));
  rows.back().polygons = "another polygon";
  rows.back().speedup.reset();
  return rows;
}

}  // namespace

TEST_CASE("bounds: plots show the first clipper, a set of bars for each bound") {
  const Plot settled = settled_plot(rows());
  CHECK(settled.categories == std::vector<std::string>{"a, pot", "b, pot"});
  REQUIRE(settled.series.size() == 3);
  CHECK(settled.series[0].y == std::vector<double>{60, 20});
  CHECK(settled.series[1].y == std::vector<double>{90, 40});
  CHECK(settled.series[2].y == std::vector<double>{90, 90});
  CHECK(settled.series[2].muted);
  const Plot speedup = speedup_plot(rows());
  REQUIRE(speedup.series.size() == 2);
  CHECK(speedup.series[0].y == std::vector<double>{2, 0.5});
  CHECK(speedup.series[0].low == std::vector<double>{1, -0.5});
  CHECK(std::isnan(speedup.series[1].y[1]));  // it was not timed
}

TEST_CASE("bounds: the finding names the extremes, and sums what is lost") {
  CHECK(
      finding(rows()) ==
      "Bounds settle 20 % (b, pot, box) to 90 % (a, pot, sphere) of the objects, and leave up to 40 % of the triangles untouched; of 500 exact verdicts 5 on rejected objects find something visible, 10 on accepted ones something to cut. Clipping gets 0.50 times (b, pot, box) to 9.00 times (b, pot, box) as fast.");
  CHECK(finding({}) == "");
}

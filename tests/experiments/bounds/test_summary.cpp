// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/bounds/rows.hpp"

#include <cmath>

#include "experiments/table/prose.hpp"
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

TEST_CASE("bounds: the finding says what is settled, what is lost and where it pays") {
  const auto checked = [](const std::vector<Row>& measured) {
    const std::string text = finding(measured);
    INFO(text);
    CHECK(faults_of_prose(text).empty());
    return text;
  };
  std::vector<Row> measured = rows();
  for (Row& row : measured) {
    row.visible_lost = row.accepted_cut = 0;
    if (row.speedup) row.speedup->low = row.speedup->median;
  }
  CHECK(
      checked(measured) ==
      "Bounding volumes settle up to 90 % of the objects without a look at their triangles, on a, and as few as 20 % on b. They lose nothing that is visible. They make clipping faster on a and b. The largest gain is that of the box.");
  for (Row& row : measured) {
    if (row.speedup && row.scene == "b") row.speedup->low = 0.5;
  }
  CHECK(checked(measured).find("faster on a, but not on b.") != std::string::npos);
  measured[0].accepted_cut = 1;
  CHECK(checked(measured).find("are WRONG: something that a plane cuts is accepted.") !=
        std::string::npos);
  measured[0].visible_lost = 1;
  CHECK(checked(measured).find("are WRONG: something visible is rejected.") != std::string::npos);
  for (Row& row : measured) row.speedup = MedianInterval{0.5, 0.4, 0.6};
  CHECK(checked(measured).ends_with("They make clipping faster on no scene."));
  CHECK(checked({}) == "No clipper was asked for.");
}

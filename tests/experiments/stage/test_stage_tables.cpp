// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "experiments/cost/stage_tables.hpp"
#include "experiments/report/row_view.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;

namespace {

StageTiming timing(const std::string& clipper, const std::string& build, double ns,
                   double speedup) {
  StageTiming t{clipper, "float", build, "copy"};
  t.bytes = {.positions = 0, .rest = 96, .out = 64};
  t.timing.ns = {ns, ns - 1, ns + 1};
  t.timing.speedup = {speedup, speedup, speedup};
  t.times_fastest = {ns / 10, ns / 11, ns / 9};
  t.limit_percent = {50, 40, 60};
  return t;
}

StageMeasurement measurement() {
  StageMeasurement m;
  m.contestants = {timing("textbook", "scalar", 100, 1),
                   timing("homogeneous/batch", "simd", 10, 10),
                   timing("homogeneous/batch", "plain", 50, 2),
                   timing("barycentric/correctly_rounded_batch", "simd", 12, 8)};
  m.contestants[2].timing.refused = "it is wrong";
  MemoryTiming pass{MemoryPass::copy_everything, 96, {}};
  pass.timing.ns = {4, 4, 4};
  pass.timing.speedup = {25, 25, 25};
  m.passes = {pass};
  return m;
}

Table stage_rows() {
  Table table = cost_stage_table();
  add_stage_rows("game_like", measurement(), table);
  return table;
}

}  // namespace

TEST_CASE("stage tables: bytes and gigabytes per second are computed from the data and the time") {
  const Table table = stage_rows();
  const auto rows = rows_of(table);
  REQUIRE(rows.size() == 5);
  CHECK(rows[0].text("clipper") == "copy everything");
  CHECK(rows[0].number("gigabytes_per_second") == Approx(2 * 96 / 4.0));
  CHECK_FALSE(rows[0].find_number("limit_percent"));
  CHECK_FALSE(rows[0].find_number("times_fastest"));
  CHECK(rows[2].number("bytes_in") == 96);
  CHECK(rows[2].number("bytes_out") == 64);
  CHECK(rows[2].number("gigabytes_per_second") == Approx(160 / 10.0));
  CHECK(rows[2].number("limit_percent") == 50);
}

TEST_CASE("stage tables: who is refused has a row without figures, and one with the reason") {
  const Table table = stage_rows();
  CHECK_FALSE(rows_of(table)[3].find_number("ns_per_triangle"));
  Table refused = cost_stage_refused_table();
  add_stage_refused_rows("game_like", measurement(), refused);
  REQUIRE(refused.rows().size() == 1);
  CHECK(rows_of(refused)[0].text("reason") == "it is wrong");
}

TEST_CASE("stage tables: the finding names the fastest and the price of correct rounding") {
  CHECK(
      stage_finding(stage_rows()) ==
      "The stage, times faster than textbook: game_like: copy 10.0 x (homogeneous/batch, 10.0 ns; "
      "correctly rounded 1.20 times its time).");
  CHECK(stage_finding(cost_stage_table()) == "");
}

TEST_CASE(
    "stage tables: the plot has a bar per clipper that was timed in SIMD, and memory's limit") {
  const Plot plot = stage_plot(stage_rows(), StageContract::copy);
  REQUIRE(plot.series.size() == 3);
  CHECK(plot.series[0].y == std::vector<double>{10});
  CHECK(plot.series[2].muted);
  CHECK(plot.series[2].y == std::vector<double>{20});  // half of it is reached
  CHECK(plot.categories == std::vector<std::string>{"game_like"});
  CHECK(stage_plot(stage_rows(), StageContract::indexed).series.empty());
}

TEST_CASE("growth table: plots have one line per clipper and contract over what grows") {
  std::vector<GrowthPoint> points;
  for (const std::int64_t n : {0, 4}) {
    GrowthPoint p{.growing = Growing::attributes,
                  .n = n,
                  .clipper = "homogeneous/batch",
                  .scalar = "float",
                  .build = "simd",
                  .contract = "copy",
                  .triangles = 1000};
    p.timing.ns = {2, 1, 3};
    points.push_back(p);
  }
  points.push_back(points.back());
  points.back().timing.refused = "wrong";
  Table growth = cost_growth_table();
  add_growth_rows(points, growth);
  REQUIRE(growth.rows().size() == 3);
  CHECK_FALSE(rows_of(growth)[0].find_number("speedup_to_textbook"));
  CHECK_FALSE(rows_of(growth)[2].find_number("ns_per_triangle"));
  const Plot plot = growth_plot(growth, Growing::attributes);
  REQUIRE(plot.series.size() == 1);
  CHECK(plot.series[0].x == std::vector<double>{4, 8});
  CHECK(growth_plot(growth, Growing::planes).series.empty());
}

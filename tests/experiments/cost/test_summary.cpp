// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cost/rows.hpp"

#include "tests/catch.hpp"

using namespace clipscope::experiments;
using namespace clipscope::experiments::cost;

namespace {

const Contestant& in_stage(std::string_view clipper, std::string_view build) {
  for (const Contestant& c : all_contestants()) {
    if (c.clipper == clipper && c.build == build && c.contract == Contract::copy) return c;
  }
  throw std::logic_error("no such contestant");
}

StageTiming timing(std::string_view clipper, std::string_view build, double ns, double speedup) {
  StageTiming t{.contestant = &in_stage(clipper, build),
                .bytes = {.positions = 0, .rest = 96, .out = 64},
                .times_fastest = {ns / 10, ns / 11, ns / 9},
                .limit_percent = {50, 40, 60}};
  t.timing.ns = {ns, ns - 1, ns + 1};
  t.timing.samples_ns = {ns, ns - 1, ns + 1};
  t.timing.speedup = {speedup, speedup, speedup};
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

struct Made {
  StageTables tables;
  PieceRecord record;

  Made() { tables.add("game_like", measurement(), record); }
};

}  // namespace

TEST_CASE("stage tables: bytes and gigabytes per second are computed from the data and the time") {
  const std::vector<StageRow> rows = Made().tables.stage.rows();
  REQUIRE(rows.size() == 5);
  CHECK(rows[0].from == InputFrom::memory);
  CHECK(rows[0].clipper == "copy everything");
  CHECK(rows[0].contract == kBytesAlone);
  CHECK(rows[0].gigabytes_per_second == Approx(2 * 96 / 4.0));
  CHECK_FALSE(rows[0].timing->limit_percent);
  CHECK_FALSE(rows[0].timing->times_fastest);
  CHECK(rows[2].bytes_in == 96);
  CHECK(rows[2].bytes_out == 64);
  CHECK(rows[2].gigabytes_per_second == Approx(160 / 10.0));
  CHECK(rows[2].timing->limit_percent->median == 50);
  CHECK(rows[2].timing->times_fastest->median == 1);
  CHECK(rows[2].timing->speedup->median == 10);
}

TEST_CASE("stage tables: who is refused has a row without figures, and one with the reason") {
  const Made made;
  CHECK_FALSE(made.tables.stage.rows()[3].timing);
  CHECK_FALSE(made.tables.stage.rows()[3].bytes_in);
  CHECK(made.record.samples.size() == 4);
  REQUIRE(made.tables.refused.rows().size() == 1);
  CHECK(made.tables.refused.rows()[0].reason == "it is wrong");
}

TEST_CASE(
    "stage tables: the plot has a bar per clipper that was timed in SIMD, and memory's limit") {
  const std::vector<StageRow> rows = Made().tables.stage.rows();
  const Plot plot = stage_plot(rows, Contract::copy, InputFrom::memory);
  CHECK(plot.name == "cost_stage_copy");
  REQUIRE(plot.series.size() == 3);
  CHECK(plot.series[0].y == std::vector<double>{10});
  CHECK(plot.series[2].muted);
  CHECK(plot.series[2].y == std::vector<double>{5});  // half of its time goes into moving bytes
  CHECK(plot.categories == std::vector<std::string>{"game_like"});
  CHECK(stage_plot(rows, Contract::indexed, InputFrom::memory).series.empty());
  CHECK(stage_plot(rows, Contract::copy, InputFrom::cache).series.empty());
}

TEST_CASE("stage tables: certainty is the correctly rounded clipper over the fastest other one") {
  const std::vector<CertaintyRow> rows = Made().tables.certainty.rows();
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].mix == "game_like");
  CHECK(rows[0].contract == Contract::copy);
  CHECK(rows[0].from == InputFrom::memory);
  CHECK(rows[0].fastest == "homogeneous/batch");
  CHECK(rows[0].fastest_ns == 10);
  CHECK(rows[0].certain_ns == 12);
  CHECK(rows[0].price.median == Approx(1.2));
  CHECK(rows[0].price.low == Approx(13.0 / 11));  // of the same round
  CHECK(rows[0].price.high == Approx(11.0 / 9));
  CHECK(rows[0].fastest_limit == 50);
  CHECK(rows[0].fastest_speedup == 10);
  CHECK(rows[0].certain_speedup == 8);
}

TEST_CASE("stage tables: who was not timed has no price of certainty") {
  StageMeasurement wrong = measurement();
  wrong.contestants[3].timing.refused = "it is wrong";
  CHECK(certainty_rows("game_like", wrong).empty());
}

TEST_CASE("growth table: plots have one line per clipper and contract over what grows") {
  TableOf<GrowthRow> table;
  for (const std::int64_t n : {0, 4}) {
    table.add({.grows = Growing::attributes,
               .n = n,
               .clipper = "homogeneous/batch",
               .scalar = "float",
               .contract = Contract::copy,
               .triangles = 1000,
               .ns = MedianInterval{2, 1, 3}});
  }
  table.add(
      {.grows = Growing::attributes, .n = 4, .clipper = "homogeneous/batch", .scalar = "float"});
  const std::vector<GrowthRow> rows = table.rows();
  REQUIRE(rows.size() == 3);
  CHECK_FALSE(rows[0].speedup);
  CHECK_FALSE(rows[2].ns);
  const Plot plot = growth_plot(rows, Growing::attributes);
  REQUIRE(plot.series.size() == 1);
  CHECK(plot.series[0].x == std::vector<double>{4, 8});
  CHECK(growth_plot(rows, Growing::planes).series.empty());
}

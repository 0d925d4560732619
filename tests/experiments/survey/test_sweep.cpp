// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/survey/sweep.hpp"

#include <tbb/global_control.h>

#include <numeric>

#include "experiments/machine/errors.hpp"
#include "experiments/survey/lattice_sweep.hpp"
#include "experiments/survey/stage_sweep.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

// A clip-space triangle that reaches beyond the right plane by n.
ClipTriangle<float, kSceneAttributes> beyond_right(float n) {
  ClipTriangle<float, kSceneAttributes> t{};
  t[0].position = {0, 0, 0, 1};
  t[1].position = {1 + n, 0, 0, 1};
  t[2].position = {0, 1, 0, 1};
  return t;
}

SweepChunk chunk_of(std::size_t index) {
  SweepChunk chunk;
  chunk.clip = {beyond_right(static_cast<float>(index)), beyond_right(-0.5f)};
  return chunk;
}

std::vector<Tally> sweep_of(const std::string& clippers) {
  Progress progress("", 0);
  return sweep({3, chunk_of}, select_contestants(clippers, {"float"}), progress);
}

Selection selection_of(const std::string& clipper) {
  Selection selection;
  selection.clipper = clipper;
  selection.scalars = {"float"};
  return selection;
}

}  // namespace

TEST_CASE("sweep: every triangle is counted once, under its outcome") {
  const auto tallies = sweep_of("homogeneous/sutherland_hodgman");
  REQUIRE(tallies.size() == 1);
  CHECK(tallies[0].primitives == 6);
  CHECK(tallies[0].failures == 0);
  CHECK(std::accumulate(tallies[0].outcomes.begin(), tallies[0].outcomes.end(), 0) == 6);
}

TEST_CASE("sweep: a failure is named with the input that shows it") {
  const auto tallies = sweep_of("whole/any_outside");
  CHECK(tallies[0].failures == 2);  // chunk 0 lies on the plane
  CHECK(tallies[0].failing_outcome() == Outcome::missing);
  CHECK(tallies[0].failing == replay_text(chunk_of(1), 0));
  CHECK(tallies[0].failing.find("--space clip --depth gl --attributes 4 : 0x0p+0") == 0);
}

TEST_CASE("sweep: the input of a failure names the options of the volume, as clip reads them") {
  SweepChunk chunk = chunk_of(1);
  chunk.volume = {.depth = DepthRange::reversed,
                  .depth_clamp = kClampNear,
                  .clip_distances = 1,
                  .open_sides = true};
  const auto begins_with = [&](const std::string& text) {
    return replay_text(chunk, 0).starts_with("--space clip " + text + " --attributes 4 : ");
  };
  CHECK(begins_with(
      "--depth reversed --depth-clamp=near --half-open=right,bottom --clip-distances 1"));
  chunk.volume = {.depth_clamp = true};
  CHECK(begins_with("--depth gl --depth-clamp"));
}

TEST_CASE("sweep: a clipper that starts in view space has nothing in clip space") {
  CHECK(sweep_of("view/sutherland_hodgman")[0].primitives == 0);
}

TEST_CASE("sweep: scalars other than float and double are refused") {
  Progress progress("", 0);
  CHECK_THROWS_AS(sweep({1, chunk_of}, select_contestants("textbook", {"exact"}), progress),
                  UsageError);
}

TEST_CASE("sweep: random triangles are the same for a seed, whatever the number of threads") {
  const auto csv = [](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const Selection selection = selection_of("homogeneous/*");
    return sweep(random_plan(20000, selection), selection).to_csv();
  };
  CHECK(csv(1) == csv(3));
  Selection other = selection_of("homogeneous/*");
  other.seed = 2;
  CHECK(csv(1) != sweep(random_plan(20000, other), other).to_csv());
}

TEST_CASE("sweep: a part of the small lattice goes through every clipper") {
  Selection selection = selection_of("*");
  selection.quick = true;
  const TableOf<SweepRow> table = sweep(lattice_plan("small", selection), selection);
  CHECK(table.rows().size() >= 15);
  for (const SweepRow& row : table.rows()) CHECK(row.tally.primitives > 10000);
}

TEST_CASE("sweep: some chunks and the others add up to all of them") {
  const Selection selection = selection_of("homogeneous/near_last");
  const Contestants contestants = swept_contestants(selection);
  const SweepPlan plan = random_plan(9000, selection);
  REQUIRE(plan.source.chunks == 5);
  Progress progress("", 5);
  const std::vector<std::size_t> even = {0, 2, 4}, odd = {1, 3};
  std::vector<SweepRow> rows = empty_rows(contestants);
  sweep(plan, odd, contestants, progress, rows);
  sweep(plan, even, contestants, progress, rows);
  CHECK(whole_table(plan, rows).to_csv() == sweep(plan, selection).to_csv());
}

TEST_CASE("sweep: triangles with the right vertices are counted by the ulp that they are off") {
  const auto tallies = sweep_of("homogeneous/sutherland_hodgman");
  CHECK(tallies[0].ulps[0] == 5);
  CHECK(tallies[0].ulps[1] == 1);  // chunk 2 is cut at y = 2/3
  Selection selection = selection_of("homogeneous/sutherland_hodgman");
  const Tally tally = sweep(random_plan(4000, selection), selection).rows().at(0).tally;
  CHECK(std::accumulate(tally.ulps.begin(), tally.ulps.end(), std::int64_t{0}) ==
        tally.outcomes[0] + tally.outcomes[1] + tally.outcomes[2] + tally.outcomes[3]);
  CHECK(tally.ulps[0] == tally.outcomes[0]);
  CHECK(tally.ulps[1] == tally.outcomes[1]);
}

TEST_CASE("sweep: the correctly rounded clipper misrounds no coordinate, a chain of cuts some") {
  const auto rounding_of = [](const std::string& clipper) {
    const Selection selection = selection_of(clipper);
    return sweep(random_plan(8000, selection), selection).rows().at(0).tally.rounding;
  };
  const RoundingCount right = rounding_of("barycentric/correctly_rounded");
  const RoundingCount chain = rounding_of("homogeneous/sutherland_hodgman");
  CHECK(right.coordinates > 10000);
  CHECK(right.misrounded == 0);
  CHECK(right.attributes == right.coordinates);
  CHECK(right.misrounded_attributes == 0);
  CHECK(chain.coordinates >= right.coordinates);
  CHECK(chain.misrounded > chain.coordinates / 100);
}

TEST_CASE(
    "sweep: stages are swept in every contract and build, and the right one misrounds nothing") {
  const Contestants contestants = stage_sweep_contestants("barycentric/correctly_rounded_batch");
  REQUIRE(contestants.size() >= 6);
  Progress progress("", 2);
  std::vector<StageSweepRow> rows = empty_stage_rows(contestants);
  const std::vector<std::size_t> chunks = {0, 1};
  sweep_stage(3000, 1, chunks, contestants, progress, rows);
  for (const StageSweepRow& row : rows) {
    INFO(row.contract << " " << row.build);
    CHECK(row.triangles == 3000);
    CHECK(row.coordinates > 2000);
    CHECK(row.misrounded == 0);
  }
  CHECK_THROWS_AS(stage_sweep_contestants("nobody/*"), UsageError);
}

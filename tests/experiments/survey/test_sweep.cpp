// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/survey/sweep.hpp"

#include <tbb/global_control.h>

#include <numeric>

#include "experiments/machine/errors.hpp"
#include "experiments/survey/lattice_sweep.hpp"
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
  return sweep(3, chunk_of, select_contestants(clippers, {"float"}), progress);
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
  CHECK(tallies[0].failing_outcome == Outcome::missing);
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
  CHECK_THROWS_AS(sweep(1, chunk_of, select_contestants("textbook", {"exact"}), progress),
                  UsageError);
}

TEST_CASE("sweep: random triangles are the same for a seed, whatever the number of threads") {
  const auto csv = [](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return sweep_random(20000, selection_of("homogeneous/*")).to_csv();
  };
  CHECK(csv(1) == csv(3));
  Selection other = selection_of("homogeneous/*");
  other.seed = 2;
  CHECK(csv(1) != sweep_random(20000, other).to_csv());
}

TEST_CASE("sweep: a part of the small lattice goes through every clipper") {
  Selection selection = selection_of("*");
  selection.quick = true;
  TableOf<SweepRow> table = lattice_table("small", selection);
  add_lattice("small", selection, table);
  CHECK(table.rows().size() >= 15);
  for (const SweepRow& row : table.rows()) CHECK(row.triangles > 10000);
}

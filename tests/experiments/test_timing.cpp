// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/measure/machine.hpp"
#include "experiments/measure/timing.hpp"
#include "experiments/scenes/builtin.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;

namespace {

std::vector<TimedBatch> soup_batches() {
  return timed_batches(make_builtin_scene("soup", {.seed = 1, .quick = true}), 2000);
}

const TimingOptions kFew{.rounds = 5, .milliseconds_per_run = 0.2, .checked_triangles = 64};

}  // namespace

TEST_CASE("timing: each contestant has one sample per round and a sane interval") {
  const auto contestants = select_contestants("*", {"float", "exact"});
  for (const Timing& timing : measure_time(soup_batches(), contestants, kFew)) {
    REQUIRE(timing.refused.empty());
    CHECK(timing.samples_ns.size() == 5);
    CHECK(timing.ns.low > 0);
    CHECK(timing.ns.low <= timing.ns.median);
    CHECK(timing.ns.median <= timing.ns.high);
    CHECK(timing.speedup.median > 0);
  }
}

TEST_CASE("timing: a contestant that breaks its promise is not timed") {
  const auto* honest = std::get<const Contestant<float>*>(find_contestant("cvv/naive", "float"));
  Contestant<float> boaster = *honest;
  boaster.promise = {.ulps = 64};  // for every triangle, attributes included
  const std::vector<AnyContestant> contestants = {&boaster};
  const auto batches =
      timed_batches(make_builtin_scene("soup_behind", {.seed = 1, .quick = true}), 500);
  const Timing timing = measure_time(batches, contestants, kFew).front();
  CHECK_FALSE(timing.refused.empty());
  CHECK(timing.samples_ns.empty());
}

TEST_CASE("timing: batches are the same each time, shuffled, and within the limit") {
  const auto a = soup_batches();
  const auto b = soup_batches();
  REQUIRE(a.size() == b.size());
  CHECK(a[0].triangles.size() <= 2000);
  CHECK(a[0].triangles.size() > 1000);
  CHECK(a[0].triangles[5][1].position == b[0].triangles[5][1].position);
}

TEST_CASE("timing: a thread can be pinned and is freed again") {
  cpu_set_t before, after;
  REQUIRE(sched_getaffinity(0, sizeof before, &before) == 0);
  {
    const PinnedThread pinned;
    cpu_set_t during;
    REQUIRE(sched_getaffinity(0, sizeof during, &during) == 0);
    if (pinned.pinned()) CHECK(CPU_COUNT(&during) == 1);
  }
  REQUIRE(sched_getaffinity(0, sizeof after, &after) == 0);
  CHECK(CPU_EQUAL(&before, &after));
}

TEST_CASE("timing: the machine is described") {
  CHECK(machine_description().find("commit") != std::string::npos);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/builtin.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/survey/contest_clock.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;

namespace {

constexpr ContestClock kFew{.rounds = 5, .milliseconds_per_run = 0.2, .checked = 64};

std::vector<Timing> timed(const std::string& scene, const Contestants& contestants) {
  const auto views = sampled_views(make_builtin_scene(scene, {.seed = 1, .quick = true}), 2000);
  return time_contestants(batches_of(views), contestants, find_contestant("textbook", "float"),
                          kFew);
}

}  // namespace

TEST_CASE("contest clock: each contestant has one sample per round and a sane interval") {
  for (const Timing& timing : timed("soup", select_contestants("*", {"float", "exact"}))) {
    REQUIRE(timing.refused == "");
    CHECK(timing.samples_ns.size() == 5);
    CHECK(timing.ns.low > 0);
    CHECK(timing.ns.low <= timing.ns.median);
    CHECK(timing.ns.median <= timing.ns.high);
    CHECK(timing.speedup.value().median > 0);
  }
}

TEST_CASE("contest clock: a contestant that breaks its promise is not timed") {
  Contestant boaster = find_contestant("cvv/naive", "float");
  boaster.promise = {.ulps = 64};  // for every triangle, attributes included
  const Timing timing = timed("soup_behind", {&boaster}).front();
  CHECK_FALSE(timing.is_timed());
  CHECK(timing.samples_ns.empty());
}

TEST_CASE("contest clock: without primitives nothing is timed") {
  const Contestant& textbook = find_contestant("textbook", "float");
  CHECK(time_contestants({}, {&textbook}, textbook, kFew).front().refused == "no primitives");
}

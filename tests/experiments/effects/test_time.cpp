// SPDX-License-Identifier: GPL-3.0-or-later
//
// Times beside the full pipeline, and what is said of them.
#include "experiments/effects/rows.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/effects/planned.hpp"

using namespace clipscope::experiments;
using namespace clipscope::experiments::effects;

namespace {

constexpr ClockOptions kFew{.rounds = 3, .milliseconds_per_run = .1};

}  // namespace

TEST_CASE("effects: a row needs no timing") {
  const Row wrong{"wrong", {}, {.polygons = 10, .changed = 3, .attribute_error = 0.5}, "none"};
  const auto views = planned("overlay");
  const Timings timings = time_planned(views, harm_of(views), kFew);
  CHECK(timings.full.samples_ns.size() == 3);
  CHECK(timings.planned.ns.median > 0);
  const Row right{"right", Times(timings), {.polygons = 5}, "none"};
  CHECK(right.times->to_full.low <= right.times->to_full.high);
  CHECK(time_plot({wrong, right}).categories.size() == 2);
}

TEST_CASE(
    "effects: a pipeline that does harm is not timed, nor a full one that breaks its promise") {
  const auto views = planned("overlay");
  const Timings harmed = time_planned(views, {.polygons = 10, .changed = 3}, kFew);
  CHECK(harmed.full.is_timed());
  CHECK_THAT(harmed.planned.refused, Catch::Contains("3 of 10 polygons"));
  CHECK(time_planned(views, {.broken = "so"}, kFew).full.refused == "so");
}

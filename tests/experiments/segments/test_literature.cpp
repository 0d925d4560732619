// SPDX-License-Identifier: GPL-3.0-or-later
//
// The published line clippers in the plane, on hard sets and over the years.
#include <algorithm>
#include <cmath>

#include "experiments/contestants/year.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/segments/literature.hpp"
#include "experiments/selection/select.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/claims/fabricated.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::segments;

namespace {

const ContestClock kShort{.rounds = 5, .milliseconds_per_run = 0.05, .checked = 32};

const Contestant& in_plane(std::string_view clipper, std::string_view scalar) {
  const Contestant* found = find_in_contract(clipper, scalar, Contract::plane, 2);
  REQUIRE(found != nullptr);
  return *found;
}

// Whether an end is beyond a side of the window.
bool is_outside(const ClipSegments& segments, std::size_t segment, std::size_t end) {
  const float* p = segments.numbers.data() + 8 * segment + 4 * end;
  return std::abs(p[0]) > 1 || std::abs(p[1]) > 1;
}

}  // namespace

TEST_CASE("plane mixes: a seed gives the same bits again, another seed gives others") {
  for (const std::string& name : plane_mixes()) {
    INFO(name);
    const ClipSegments mix = make_plane_mix(name, 50, 7);
    CHECK(mix.size() == 50);
    CHECK(mix.numbers == make_plane_mix(name, 50, 7).numbers);
    CHECK(mix.numbers != make_plane_mix(name, 50, 8).numbers);
  }
  CHECK_THROWS_AS(make_plane_mix("no_such_mix", 1, 1), UsageError);
}

TEST_CASE("plane mixes: a box reaches as far beyond the window as its name says") {
  const ClipSegments mix = make_plane_mix("box_10", 500, 1);
  const auto [low, high] = std::ranges::minmax(mix.numbers);
  CHECK(low < -9);
  CHECK(low >= -10);
  CHECK(high > 9);
  CHECK(high <= 10);
}

TEST_CASE("plane mixes: the ends of each kind of segment are where its name says") {
  for (const auto& [name, ends] : {std::pair{"inside", 0},
                                   {"one_end_out", 1},
                                   {"both_ends_out", 2},
                                   {"beside", 2},
                                   {"past_corner", 2}}) {
    const ClipSegments mix = make_plane_mix(name, 100, 3);
    for (std::size_t i = 0; i < mix.size(); ++i) {
      CHECK(is_outside(mix, i, 0) + is_outside(mix, i, 1) == ends);
    }
  }
}

TEST_CASE("hard sets: those of the plane lie in it, and only whole segments are left out") {
  for (const std::string& name : hard_sets()) {
    INFO(name);
    const ClipSegments set = make_hard_set(name, 300, 1);
    CHECK(set.size() > 250);
    CHECK(set.size() <= 300);
    CHECK(set.numbers.size() == 8 * set.size());
    bool flat = true;
    for (std::size_t i = 0; i < set.numbers.size(); i += 4) {
      flat = flat && set.numbers[i + 2] == 0 && set.numbers[i + 3] == 1;
      CHECK(std::isfinite(set.numbers[i]));
    }
    CHECK(flat == set.in_plane);
  }
  CHECK_THROWS_AS(make_hard_set("no_such_set", 1, 1), UsageError);
}

TEST_CASE("hard sets: in exact arithmetic every method is right on every set of the plane") {
  const Contestants exact = contestants_in(Contract::plane, "*", {"exact"});
  REQUIRE(exact.size() >= 4);
  for (const std::string& name : hard_sets()) {
    const ClipSegments set = make_hard_set(name, 400, 1);
    if (!set.in_plane) continue;
    const std::vector<HardRow> rows = judge_hard_set(set, exact);
    REQUIRE(rows.size() == exact.size());
    for (const HardRow& row : rows) {
      INFO(name << " " << row.clipper << ": " << row.wrong_kinds << " " << row.first);
      CHECK(row.segments == static_cast<std::int64_t>(set.size()));
      CHECK(row.wrong == 0);
    }
  }
}

TEST_CASE("hard sets: what is wrong is counted, by kind, with an input to see it again") {
  const std::vector<HardRow> rows =
      judge_hard_set(make_hard_set("far", 600, 1), {&in_plane(kPlaneBaseline, "float")});
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].wrong > 0);
  CHECK_FALSE(rows[0].wrong_kinds.empty());
  CHECK_FALSE(rows[0].first.empty());
}

TEST_CASE("hard sets: a method of the plane is not asked about what lies out of it") {
  const ClipSegments set = make_hard_set("w_sign", 50, 1);
  CHECK(judge_hard_set(set, {&in_plane(kPlaneBaseline, "float")}).empty());
  CHECK(judge_hard_set(set, {&find_contestant("homogeneous/liang_barsky", "float", 2)}).size() ==
        1);
}

TEST_CASE("literature: every line clipper's source ends with the year of its method") {
  for (const Contestant* c : contestants_in(Contract::full, "*", {"float"})) {
    INFO(c->clipper);
    REQUIRE(year_of(c->source));
    CHECK(year_of(c->source) >= 1968);
    CHECK(year_of(c->source) <= 2026);
  }
}

TEST_CASE("literature: in the plane outcodes settle inside and beside without a division") {
  for (const char* mix : {"inside", "beside"}) {
    const auto rows = measure_in_plane(make_plane_mix(mix, 200, 1),
                                       {&in_plane(kPlaneBaseline, "float")}, 200, kShort);
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].divisions == 0.0);
    CHECK(rows[0].additions == 0.0);
    CHECK(rows[0].comparisons > 0.0);
    CHECK(rows[0].wrong == 0);
    REQUIRE(rows[0].timing);
    CHECK(rows[0].timing->speedup->median == Approx(1).margin(0.5));
  }
}

TEST_CASE("literature: each end that moves costs one division by products, in double as in float") {
  const Contestants both = {&in_plane("window/liang_barsky_division_free", "float"),
                            &in_plane("window/liang_barsky_division_free", "double")};
  const auto rows = measure_in_plane(make_plane_mix("both_ends_out", 200, 1), both, 200, kShort);
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].divisions == 2.0);
  CHECK_FALSE(rows[1].divisions);
  CHECK(rows[0].visible == 200);
}

TEST_CASE("literature: on the frontier is who nobody beats in time and wrong answers") {
  std::vector<TimeRow> times;
  std::vector<HardRow> hard;
  const auto add = [&](const char* clipper, double ns, std::int64_t wrong) {
    times.push_back(
        {.mix = "inside", .clipper = clipper, .scalar = "float", .timing = timing(ns, 1)});
    hard.push_back({.set = "far",
                    .contract = Contract::full,
                    .clipper = clipper,
                    .scalar = "float",
                    .segments = 100,
                    .wrong = wrong});
  };
  add("a", 10, 5);
  add("b", 20, 1);
  add("c", 30, 5);
  const std::vector<SegmentFrontierRow> rows = segment_frontier(times, hard);
  REQUIRE(rows.size() == 3);
  CHECK(rows[0].standing == Standing::frontier);
  CHECK(rows[1].standing == Standing::frontier);
  CHECK(rows[2].standing == Standing::dominated);
  CHECK(rows[2].dominated_by == "a float");
  CHECK(rows[1].hard_wrong_percent == 1.0);
  const Plot plot = frontier_plot(rows);
  REQUIRE(plot.series.size() == 2);
  CHECK(plot.series[0].labels == std::vector<std::string>{"a float", "b float"});
}

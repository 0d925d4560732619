// SPDX-License-Identifier: GPL-3.0-or-later
//
// The contest and its tables on a small set.
#include <algorithm>

#include "experiments/frontier/contest.hpp"
#include "experiments/frontier/rows.hpp"
#include "experiments/scenes/builtin.hpp"
#include "experiments/selection/select.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;
using namespace clipscope::experiments::frontier;

namespace {

std::vector<Entry> contest(const Contestants& contestants) {
  const auto views =
      sampled_views(make_builtin_scene("soup_straddling", {.seed = 1, .quick = true}), 200);
  Progress progress("", 200 * contestants.size());
  return hold_contest(views, contestants, {.rounds = 5, .milliseconds_per_run = 0.1, .checked = 32},
                      progress);
}

std::vector<Entry> contest() {
  return contest(
      select_contestants("homogeneous/sutherland_hodgman", {"float", "double", "exact"}));
}

// An entry made by hand.
Entry entry(const Contestant& contestant, double ns, double px) {
  Entry e{.contestant = &contestant};
  e.timing.ns = {ns, ns, ns};
  e.accuracy.visible = 1;
  e.accuracy.coordinates = 4;
  e.accuracy.error_px.add(px);
  return e;
}

Contestant named(std::string_view clipper, Contract contract = Contract::full) {
  return {.clipper = clipper,
          .format = find_contestant("textbook", "float").format,
          .contract = contract};
}

const Contestant kA = named("a"), kB = named("b"), kC = named("c");

template <class Row>
std::vector<Row> rows_of(std::span<const Entry> entries) {
  TableOf<Row> table;
  add_rows("set", entries, table);
  return table.rows();
}

}  // namespace

TEST_CASE("frontier: exact arithmetic has no error and is the slowest member") {
  const std::vector<Entry> entries = contest();
  CHECK(entries[2].error(Measure::max_px) == 0);
  CHECK(entries[2].rank(Measure::max_px).standing == Standing::frontier);
  CHECK(steps_of(entries, Measure::max_px).back() == 2);
}

TEST_CASE("frontier: who breaks the promise is named, has errors but no time, and no rank") {
  Contestant boaster = find_contestant("whole/any_outside", "float");
  boaster.promise = {.ulps = 64};
  const std::vector<Entry> entries = contest({&boaster, &find_contestant("textbook", "float")});
  const auto rows = rows_of<Row>(entries);
  CHECK(rows[0].by_px.standing == Standing::unranked);
  CHECK(rows[0].wrong_percent.value() > 0);
  CHECK_FALSE(rows[0].timing);
  CHECK(rows[1].by_px.standing == Standing::frontier);
  const auto refused = rows_of<RefusedRow>(entries);
  REQUIRE(refused.size() == 1);
  CHECK(refused[0].clipper == "whole/any_outside");
}

TEST_CASE("frontier: the dominated names the one that beats it; steps say what time buys") {
  std::vector<Entry> entries = {entry(kA, 10, 0.5), entry(kB, 20, 0.25), entry(kC, 30, 0.25)};
  rank(entries);
  const auto rows = rows_of<Row>(entries);
  CHECK(rows[2].by_px.standing == Standing::dominated);
  CHECK(rows[2].by_px.dominated_by == "b float");
  const StepRow step = rows_of<StepRow>(entries).front();
  CHECK(step.measure == Measure::max_px);
  CHECK(step.from == "a float");
  CHECK(step.to == "b float");
  CHECK(step.time_percent == Approx(100));
  CHECK(step.buys == "0.250 px instead of 0.500");
}

TEST_CASE("frontier: where nothing is visible nobody is ranked, drawn or praised") {
  std::vector<Entry> entries = {entry(kA, 30, 0), entry(kB, 50, 0)};
  for (Entry& e : entries) e.accuracy = {};
  rank(entries);
  const std::vector<Row> rows = rows_of<Row>(entries);
  for (const Row& row : rows) CHECK(row.by_px.standing == Standing::unranked);
  for (const Measure measure : kMeasures) {
    const Plot plot = frontier_plot(rows, {"set", measure});
    for (const Series& series : plot.series) CHECK(series.x.empty());
  }
  CHECK(finding(rows) == "No contestant could be judged and timed.");
}

TEST_CASE("frontier: altered errors change the ranks") {
  std::vector<Entry> entries = {entry(kA, 10, 0.5), entry(kB, 20, 0.25)};
  rank(entries);
  CHECK(entries[1].rank(Measure::max_px).standing == Standing::frontier);
  entries[1].accuracy.error_px.add(0.75);
  rank(entries);
  CHECK(entries[1].rank(Measure::max_px).standing == Standing::dominated);
}

TEST_CASE("frontier: a plot draws an error of 0 on a line beneath all others") {
  std::vector<Entry> entries = {entry(kA, 10, 0.5), entry(kB, 20, 0)};
  rank(entries);
  const Plot plot =
      frontier_plot(rows_of<Row>(entries), {.set = "set", .measure = Measure::max_px});
  const auto line = std::find_if(plot.series.begin(), plot.series.end(),
                                 [](const Series& s) { return s.name == "not dominated"; });
  REQUIRE(line != plot.series.end());
  REQUIRE(line->x == std::vector<double>{10, 20});
  CHECK(line->y[0] == 0.5);
  CHECK(line->y[1] > 0);
  CHECK(line->y[1] < 0.5 / 99);
}

TEST_CASE("frontier: contracts of the stage have frontiers of their own, errors the same in both") {
  const Scene scene = make_builtin_scene("soup_straddling", {.seed = 1, .quick = true});
  const StageInput input = scene_input(scene, 200);
  const auto contracts = hold_stage_contest(
      input, stage_contestants(input), 10'000,
      {.rounds = 5, .milliseconds_per_run = 0.1, .check = {.triangles = 500, .exact = 16}});
  REQUIRE(contracts.size() == 4);
  for (const std::size_t i : {0u, 2u}) {
    CHECK(contracts[i].front().contestant->clipper == "textbook");
    CHECK(contracts[i + 1].front().contestant->contract == Contract::number);
    for (const Entry& e : contracts[i]) {
      CHECK(e.from == (i == 0 ? InputFrom::memory : InputFrom::cache));
    }
  }
  for (const std::vector<Entry>& entries : contracts) {
    bool any = false;
    for (const Entry& e : entries) {
      any |= e.rank(Measure::misrounded).standing == Standing::frontier;
      if (e.contestant->clipper != "barycentric/correctly_rounded_batch") continue;
      CHECK(e.timing.refused == "");
      CHECK(e.error(Measure::misrounded) == 0);
      CHECK(e.error(Measure::wrong) == 0);
    }
    CHECK(any);
  }
  const auto error_of = [&](std::size_t contract, std::string_view clipper) {
    for (const Entry& e : contracts[contract]) {
      if (e.contestant->clipper == clipper) return e.error(Measure::misrounded);
    }
    return -1.0;
  };
  CHECK(error_of(0, "homogeneous/batch") == error_of(1, "homogeneous/batch"));
  CHECK(error_of(0, "homogeneous/batch") > 0);
}

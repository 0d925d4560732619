// SPDX-License-Identifier: GPL-3.0-or-later
//
// The contest and its tables on a small set.
#include <algorithm>

#include "experiments/frontier/contest.hpp"
#include "experiments/frontier/plots.hpp"
#include "experiments/frontier/tables.hpp"
#include "experiments/report/row_view.hpp"
#include "experiments/scenes/builtin.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;

namespace {

const TimingOptions kFew{.rounds = 5, .milliseconds_per_run = 0.1, .checked_triangles = 32};

std::vector<Entry> contest(std::span<const AnyContestant> contestants) {
  const auto batches =
      timed_batches(make_builtin_scene("soup_straddling", {.seed = 1, .quick = true}), 200);
  Progress progress("", 200 * contestants.size());
  return hold_contest(batches, contestants, kFew, progress);
}

std::vector<Entry> contest() {
  return contest(
      select_contestants("homogeneous/sutherland_hodgman", {"float", "double", "exact"}));
}

// An entry made by hand.
Entry entry(const std::string& clipper, double ns, double px) {
  Entry e{clipper, "float", {}, {}};
  e.timing.ns = {ns, ns, ns};
  e.accuracy.visible = 1;
  e.accuracy.coordinates = 4;
  e.accuracy.error_px.add(px);
  return e;
}

void rank(std::vector<Entry>& entries) {
  for (const ErrorMeasure measure : kErrorMeasures) {
    const auto ranks = pareto_frontier(frontier_points(entries, measure));
    for (std::size_t i = 0; i < entries.size(); ++i) {
      entries[i].ranks[static_cast<std::size_t>(measure)] = ranks[i];
    }
  }
}

}  // namespace

TEST_CASE("frontier: exact arithmetic has no error and is the slowest member") {
  const std::vector<Entry> entries = contest();
  CHECK(entries[2].error(ErrorMeasure::max_px) == 0);
  CHECK(entries[2].rank(ErrorMeasure::max_px).standing == Standing::frontier);
  CHECK(steps_of(entries, ErrorMeasure::max_px).back() == 2);
}

TEST_CASE("frontier: who breaks the promise is named, has errors but no time, and no rank") {
  const auto* honest =
      std::get<const Contestant<float>*>(find_contestant("whole/any_outside", "float"));
  Contestant<float> boaster = *honest;
  boaster.promise = {.ulps = 64};
  const std::vector<AnyContestant> contestants = {&boaster, find_contestant("textbook", "float")};
  const std::vector<Entry> entries = contest(contestants);
  Table frontier = frontier_table(), refused = frontier_refused_table();
  add_frontier_rows("set", entries, frontier);
  add_refused_rows("set", entries, refused);
  const RowView row = rows_of(frontier)[0];
  CHECK(row.text("on_frontier") == "not timed");
  CHECK(row.number("wrong_percent") > 0);
  CHECK_THROWS(row.number("ns_per_triangle"));
  REQUIRE(refused.rows().size() == 1);
  CHECK(rows_of(refused)[0].text("clipper") == "whole/any_outside");
  CHECK(rows_of(frontier)[1].text("on_frontier") == "yes");
}

TEST_CASE("frontier: the dominated names the one that beats it; steps say what time buys") {
  std::vector<Entry> entries = {entry("a", 10, 0.5), entry("b", 20, 0.25), entry("c", 30, 0.25)};
  rank(entries);
  Table frontier = frontier_table(), steps = frontier_steps_table();
  add_frontier_rows("set", entries, frontier);
  add_step_rows("set", entries, steps);
  CHECK(rows_of(frontier)[2].text("on_frontier") == "no");
  CHECK(rows_of(frontier)[2].text("dominated_by") == "b float");
  const RowView step = rows_of(steps)[0];
  CHECK(step.text("measure") == "max_px");
  CHECK(step.text("from") == "a float");
  CHECK(step.text("to") == "b float");
  CHECK(step.number("time_percent") == Approx(100));
  CHECK(step.text("buys") == "0.250 px instead of 0.500");
}

TEST_CASE("frontier: altered errors change the ranks") {
  std::vector<Entry> entries = {entry("a", 10, 0.5), entry("b", 20, 0.25)};
  rank(entries);
  CHECK(entries[1].rank(ErrorMeasure::max_px).standing == Standing::frontier);
  entries[1].accuracy.error_px.add(0.75);
  rank(entries);
  CHECK(entries[1].rank(ErrorMeasure::max_px).standing == Standing::dominated);
}

TEST_CASE("frontier: a plot draws an error of 0 on a line beneath all others") {
  std::vector<Entry> entries = {entry("a", 10, 0.5), entry("b", 20, 0)};
  rank(entries);
  Table frontier = frontier_table();
  add_frontier_rows("set", entries, frontier);
  const Plot plot = frontier_plot("set", ErrorMeasure::max_px, frontier);
  const auto found = std::find_if(plot.series.begin(), plot.series.end(),
                                  [](const Series& s) { return s.name == "not dominated"; });
  REQUIRE(found != plot.series.end());
  const Series& line = *found;
  REQUIRE(line.x == std::vector<double>{10, 20});
  CHECK(line.y[0] == 0.5);
  CHECK(line.y[1] > 0);
  CHECK(line.y[1] < 0.5 / 99);
}

TEST_CASE("frontier: contracts of the stage have frontiers of their own, errors the same in both") {
  const Scene scene = make_builtin_scene("soup_straddling", {.seed = 1, .quick = true});
  const StageTimingOptions few{
      .rounds = 5, .milliseconds_per_run = 0.1, .check = {.triangles = 500, .exact = 16}};
  const auto contracts = hold_stage_contest(
      scene_input(scene, 200), [](std::string_view) { return true; }, few);
  REQUIRE(contracts.size() == 2);
  CHECK(contracts[0].front().clipper == "textbook");
  CHECK(contracts[1].front().contract == "reference");
  for (const std::vector<Entry>& entries : contracts) {
    bool any = false;
    for (const Entry& e : entries) {
      any |= e.rank(ErrorMeasure::misrounded).standing == Standing::frontier;
      if (e.clipper != "barycentric/correctly_rounded_batch") continue;
      CHECK(e.timing.refused == "");
      CHECK(e.error(ErrorMeasure::misrounded) == 0);
      CHECK(e.error(ErrorMeasure::wrong) == 0);
    }
    CHECK(any);
  }
  const auto error_of = [&](std::size_t contract, std::string_view clipper) {
    for (const Entry& e : contracts[contract]) {
      if (e.clipper == clipper) return e.error(ErrorMeasure::misrounded);
    }
    return -1.0;
  };
  CHECK(error_of(0, "homogeneous/batch") == error_of(1, "homogeneous/batch"));
  CHECK(error_of(0, "homogeneous/batch") > 0);
}

TEST_CASE("frontier: the finding reads the steps of the stage's rounding frontier") {
  std::vector<Entry> entries = {entry("a", 10, 0.5), entry("b", 11, 0.25)};
  for (Entry& e : entries) e.contract = "copy";
  entries[1].accuracy.correctly_rounded = 1;  // of 4
  rank(entries);
  Table frontier = frontier_table(), steps = frontier_steps_table();
  std::vector<Entry> full = {entry("a", 10, 0.5)};
  rank(full);
  add_frontier_rows("set", full, frontier);
  add_frontier_rows("set", entries, frontier);
  add_step_rows("set", entries, steps);
  const std::string finding = frontier_finding(frontier, steps);
  INFO(finding);
  CHECK(finding.find("1 of 1 are not dominated; in the stage by copy +10 % time buys 25.0 % more "
                     "correctly rounded coordinates (a float to b float)") != std::string::npos);
}

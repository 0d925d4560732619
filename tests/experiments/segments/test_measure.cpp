// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is measured of line clippers: outcomes, operations, time; and that it is refused when wrong.
#include <filesystem>

#include "experiments/report/experiment.hpp"
#include "experiments/segments/rows.hpp"
#include "experiments/selection/replay_text.hpp"
#include "experiments/selection/select.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments::segments {
extern const Experiment kExperiment;
}

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::segments;

namespace {

const ContestClock kFew{.rounds = 5, .milliseconds_per_run = 0.05, .checked = 32};

OperationsRow operations_of(std::string_view clipper, std::string_view mix) {
  return count_operations(make_mix(mix, 200, 1), {&find_contestant(clipper, "counting", 2)})
      .front();
}

}  // namespace

TEST_CASE(
    "segments: in exact arithmetic every clipper but the naive one gets every segment exactly") {
  for (const std::string& name : builtin_mixes()) {
    const Contestants contestants = select_contestants("*", {"exact"}, 2);
    const auto tallies = judge(make_mix(name, 40, 4), contestants);
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      INFO(name << " " << contestants[i]->clipper);
      if (contestants[i]->clipper == "cvv/liang_barsky_naive" && name == "cross_w0") {
        CHECK(tallies[i].failures > 0);
        CHECK_FALSE(wrong_kinds(tallies[i]).empty());
      } else {
        CHECK(sum_of(tallies[i].outcomes) == tallies[i].outcomes.front());
        CHECK(tallies[i].max_px == 0);
        CHECK(wrong_kinds(tallies[i]).empty());
      }
    }
  }
}

TEST_CASE("segments: kinds of failure are told with how many there are of each") {
  Tally tally;
  tally.outcomes[static_cast<std::size_t>(Outcome::exact)] = 5;
  tally.outcomes[static_cast<std::size_t>(Outcome::visible)] = 1;
  tally.outcomes[static_cast<std::size_t>(Outcome::missing)] = 3;
  CHECK(wrong_kinds(tally) == "1 visible, 3 missing");
}

TEST_CASE("segments: the worst segment is told with what is needed to see it again") {
  const Mix mix = make_mix("cross_one", 100, 1);
  const Tally tally =
      judge(mix, {&find_contestant("homogeneous/cohen_sutherland", "float", 2)}).front();
  REQUIRE(tally.max_px > 0);
  const Batch batch = mix.views.front().batch();
  bool is_one_of_them = false;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    is_one_of_them = is_one_of_them || replay_text(batch, i) == tally.worst;
  }
  CHECK(is_one_of_them);
}

TEST_CASE(
    "segments: outcodes settle without a cut division, published Liang-Barsky never accepts so") {
  for (const std::string_view mix : {"inside", "outside"}) {
    CHECK(operations_of("homogeneous/cohen_sutherland", mix).cut_divisions == 0.0);
    CHECK(operations_of("homogeneous/liang_barsky_division_free", mix).cut_divisions == 0.0);
  }
  CHECK(operations_of("homogeneous/liang_barsky", "inside").divisions_per_accepted == 6.0);
  CHECK(operations_of("view/cyrus_beck", "outside").divisions_per_rejected == 6.0);
  CHECK(operations_of("view/cyrus_beck", "outside").rejected_free_percent == 0.0);
}

TEST_CASE("segments: every segment is counted once, by what becomes of it") {
  const OperationsRow inside = operations_of("homogeneous/cohen_sutherland", "inside");
  CHECK(inside.rejected_percent == 0.0);
  CHECK(inside.divisions_per_accepted);
  CHECK_FALSE(inside.divisions_per_rejected);
  CHECK_FALSE(inside.divisions_per_shortened);
  const OperationsRow outside = operations_of("homogeneous/cohen_sutherland", "outside");
  CHECK(outside.rejected_percent == 100.0);
  CHECK_FALSE(outside.divisions_per_accepted);
  CHECK_FALSE(outside.moved_ends_per_shortened);
}

TEST_CASE("segments: by products each moved end costs one division, by outcodes some cost more") {
  const auto products = operations_of("homogeneous/liang_barsky_division_free", "cross_several");
  CHECK(products.rejected_percent == 0.0);
  CHECK_FALSE(products.divisions_per_accepted);
  CHECK(products.moved_ends_per_shortened > 1.0);
  CHECK(products.divisions_per_shortened == products.moved_ends_per_shortened);
  const auto codes = operations_of("homogeneous/cohen_sutherland", "cross_several");
  CHECK(codes.divisions_per_shortened > codes.moved_ends_per_shortened);
}

TEST_CASE("segments: after the divide the four divisions per vertex are not taken for cuts") {
  for (const std::string_view clipper : {"cvv/cohen_sutherland", "window/nicholl_lee_nicholl"}) {
    const OperationsRow operations = operations_of(clipper, "inside");
    CHECK(operations.divisions == 8.0);
    CHECK(operations.divisions_per_accepted == 0.0);
    CHECK(operations_of(clipper, "outside").rejected_undivided_percent == 0.0);
  }
}

TEST_CASE("segments: an intersection costs 6 multiplications with any plane, none in clip space") {
  const std::vector<IntersectionRow> costs = intersection_costs();
  REQUIRE(costs.size() == 6);
  const std::array<std::uint64_t, 6> multiplications = {6, 4, 0, 0, 0, 0};
  for (std::size_t i = 0; i < costs.size(); ++i) {
    INFO(costs[i].form);
    CHECK(costs[i].cut.multiplications == multiplications[i]);
    CHECK(costs[i].cut.divisions == 1);
    CHECK(costs[i].divisions_uncut == 0);
    CHECK(costs[i].point_multiplications == (i < 2 ? 3 : 4));
  }
}

TEST_CASE("segments: each contestant is timed once per round, one that breaks its promise is not") {
  const Mix mix = make_mix("cross_w0", 300, 1);
  for (const Timing& timing :
       time_clippers(mix, select_contestants("*", {"float", "double"}, 2), kFew)) {
    INFO(timing.refused);
    CHECK(timing.samples_ns.size() == 5);
    CHECK(timing.ns.low > 0);
    REQUIRE(timing.speedup);
    CHECK(timing.speedup->median > 0);
  }
  Contestant boaster = find_contestant("cvv/liang_barsky_naive", "float", 2);
  boaster.promise = {.ulps = 64};
  const Timing refused = time_clippers(mix, {&boaster}, kFew).front();
  CHECK_FALSE(refused.refused.empty());
  CHECK(refused.samples_ns.empty());
}

TEST_CASE("segments: a pattern that means triangles only leaves the tables of clippers empty") {
  const auto out = std::filesystem::temp_directory_path() / "clipscope-segments-test";
  Selection selection;
  selection.clipper = "textbook";
  selection.quick = true;
  const ExperimentContext context(selection, out);
  kExperiment.run(context);
  CHECK(context.emitted("segments")->rows().empty());
  CHECK(context.emitted("segments_operations")->rows().empty());
  CHECK(context.emitted("segments_intersection")->rows().size() == 6);
  std::filesystem::remove_all(out);
}

TEST_CASE("segments: the plots are made from rows alone") {
  const auto row = [](const char* mix, const char* clipper, double ns, std::int64_t wrong) {
    TimeRow r{.mix = mix, .clipper = clipper, .scalar = "float"};
    r.timing = Timing{};
    r.wrong = wrong;
    r.timing->ns = {ns, ns, ns};
    return r;
  };
  std::vector<TimeRow> times = {row("a", "slow", 2, 3), row("a", "quick", 1, 0),
                                row("b", "slow", 2, 4), row("b", "quick", 3, 0)};
  times[2].timing.reset();
  const Plot plot = time_plot(times);
  CHECK(plot.categories == std::vector<std::string>{"a", "b"});
  REQUIRE(plot.series.size() == 2);
  CHECK(plot.series[0].name == "slow");
  CHECK(plot.series[0].y[0] == 2);
  CHECK(std::isnan(plot.series[0].y[1]));
  CHECK(plot.series[1].y == std::vector<double>{1, 3});
  CHECK(time_plot({}).series.empty());
  CHECK(divisions_plot({}).series.empty());
}

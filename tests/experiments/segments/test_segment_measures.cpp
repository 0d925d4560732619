// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is measured of line clippers: outcomes, operations, time; and that it is refused when wrong.
#include <filesystem>

#include "experiments/experiment.hpp"
#include "experiments/segments/judge.hpp"
#include "experiments/segments/operations.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

const TimingOptions kFew{.rounds = 5, .milliseconds_per_run = 0.05, .checked_triangles = 32};

SegmentOperations operations_of(std::string_view clipper, std::string_view mix) {
  const std::vector<const Contestant<Counted, 2>*> contestants = {
      std::get<const Contestant<Counted, 2>*>(find_contestant<2>(clipper, "counting"))};
  return count_operations(make_mix(mix, 200, 1), contestants, 200).front();
}

}  // namespace

TEST_CASE(
    "segments: in exact arithmetic every clipper but the naive one gets every segment exactly") {
  for (const std::string& name : builtin_mixes()) {
    const auto contestants = select_contestants<2>("*", {"exact"});
    const auto tallies = judge_segments(make_mix(name, 40, 4), contestants, 40);
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      const std::string_view clipper = clipper_name<2>(contestants[i]);
      INFO(name << " " << clipper);
      if (clipper == "cvv/liang_barsky_naive" && name == "cross_w0") {
        CHECK(tallies[i].wrong() > 0);
        CHECK_FALSE(tallies[i].wrong_kinds().empty());
      } else {
        CHECK(tallies[i].visible() == tallies[i].outcomes.front());
        CHECK(tallies[i].max_px == 0);
      }
    }
  }
}

TEST_CASE("segments: the worst segment is told with what is needed to see it again") {
  const std::vector<SegmentContestant> contestants = {
      find_contestant<2>("homogeneous/cohen_sutherland", "float")};
  const SegmentMix mix = make_mix("cross_one", 100, 1);
  const SegmentTally tally = judge_segments(mix, contestants, 100).front();
  REQUIRE(tally.max_px > 0);
  const auto& segments = mix.batches.front().segments;
  const bool is_one_of_them = std::ranges::any_of(segments, [&](const SceneSegment& s) {
    return replay_text(mix.batches.front().view, s) == tally.worst;
  });
  CHECK(is_one_of_them);
}

TEST_CASE(
    "segments: outcodes settle without a cut division, published Liang-Barsky never accepts so") {
  for (const std::string_view mix : {"inside", "outside"}) {
    const SegmentOperations codes = operations_of("homogeneous/cohen_sutherland", mix);
    CHECK(codes.segments == 200);
    CHECK(codes.accepted.cut_divisions + codes.rejected.cut_divisions == 0);
    const SegmentOperations products = operations_of("homogeneous/liang_barsky_division_free", mix);
    CHECK(products.accepted.cut_divisions + products.rejected.cut_divisions == 0);
  }
  CHECK(operations_of("homogeneous/liang_barsky", "inside").accepted.cut_divisions == 6 * 200);
  CHECK(operations_of("view/cyrus_beck", "outside").rejected.cut_divisions == 6 * 200);
  CHECK(operations_of("view/cyrus_beck", "outside").rejected.without_cut_division == 0);
}

TEST_CASE("segments: by products each moved end costs one division, by outcodes some cost more") {
  const auto products = operations_of("homogeneous/liang_barsky_division_free", "cross_several");
  CHECK(products.shortened.segments == 200);
  CHECK(products.ends_moved > 200);
  CHECK(products.shortened.cut_divisions == products.ends_moved);
  const auto codes = operations_of("homogeneous/cohen_sutherland", "cross_several");
  CHECK(codes.shortened.cut_divisions > codes.ends_moved);
}

TEST_CASE("segments: after the divide the four divisions per vertex are not taken for cuts") {
  for (const std::string_view clipper : {"cvv/cohen_sutherland", "window/nicholl_lee_nicholl"}) {
    const SegmentOperations operations = operations_of(clipper, "inside");
    CHECK(operations.total.divisions == 8 * 200);
    CHECK(operations.accepted.cut_divisions == 0);
    CHECK(operations_of(clipper, "outside").rejected.without_division == 0);
  }
}

TEST_CASE("segments: an intersection costs 6 multiplications with any plane, none in clip space") {
  const std::vector<IntersectionCost> costs = intersection_costs();
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
  const SegmentMix mix = make_mix("cross_w0", 300, 1);
  const auto contestants = select_contestants<2>("*", {"float", "double"});
  for (const Timing& timing : measure_segment_time(mix, contestants, kFew)) {
    INFO(timing.refused);
    CHECK(timing.samples_ns.size() == 5);
    CHECK(timing.ns.low > 0);
    CHECK(timing.speedup.median > 0);
  }
  Contestant<float, 2> boaster =
      *std::get<const Contestant<float, 2>*>(find_contestant<2>("cvv/liang_barsky_naive", "float"));
  boaster.promise = {.ulps = 64};
  const std::vector<SegmentContestant> one = {&boaster};
  const Timing refused = measure_segment_time(mix, one, kFew).front();
  CHECK_FALSE(refused.refused.empty());
  CHECK(refused.samples_ns.empty());
}

TEST_CASE("segments: a pattern that means triangles only leaves the tables of clippers empty") {
  const auto out = std::filesystem::temp_directory_path() / "clipscope-segments-test";
  Selection selection;
  selection.clipper = "textbook";
  selection.quick = true;
  const ExperimentContext context(selection, out);
  run_segments(context);
  CHECK(context.emitted("segments")->rows().empty());
  CHECK(context.emitted("segments_operations")->rows().empty());
  CHECK(context.emitted("segments_intersection")->rows().size() == 6);
  std::filesystem::remove_all(out);
}

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where time goes: a clipper with a step left out computes what the whole one computes before that step.
#include "experiments/contestants/contestants_of.hpp"
#include "experiments/cost/split.hpp"
#include "experiments/cost/tables.hpp"
#include "experiments/measure/batches.hpp"
#include "experiments/measure/staged.hpp"
#include "experiments/report/row_view.hpp"
#include "experiments/scenes/builtin.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

std::vector<TimedBatch> batches_of(const std::string& scene, std::size_t limit = 400) {
  return timed_batches(make_builtin_scene(scene, {.seed = 1, .quick = true}), limit);
}

template <class C, class U>
PolygonStream<U, kSceneAttributes> run(const TimedBatch& batch) {
  PolygonStream<U, kSceneAttributes> out;
  const auto triangles = simplices_cast<U>(batch.triangles);
  clip_batch<C>(projection_of<U>(batch.view), std::span(std::as_const(triangles)), out);
  return out;
}

// Checks that finish(left out) has the bits of the whole answer.
template <class C, Skip kSkip, class Finish>
void check_bits(const std::string& scene, Finish&& finish) {
  for (const TimedBatch& batch : batches_of(scene)) {
    const auto whole = run<C, float>(batch);
    const auto before = run<C, Staged<float, kSkip>>(batch);
    const auto projection = projection_of<float>(batch.view);
    for (std::size_t i = 0; i < batch.triangles.size(); ++i) {
      REQUIRE(before[i].size() == whole[i].size());
      for (std::size_t v = 0; v < whole[i].size(); ++v) {
        const auto& p = before[i][v].position;
        const Vec4<float> ndc =
            finish(projection, Vec4<float>(p[0].value(), p[1].value(), p[2].value(), p[3].value()));
        REQUIRE(ndc == whole[i][v].position);
      }
    }
  }
}

Vec4<float> divided(const Projection<float>&, const Vec4<float>& clip) {
  return clipscope::to_ndc(clip);
}

Vec4<float> projected(const Projection<float>& projection, const Vec4<float>& view) {
  return clipscope::to_ndc(clipscope::to_clip(projection, Vec3<float>(view[0], view[1], view[2])));
}

const TimingOptions kFew{.rounds = 5, .milliseconds_per_run = 0.1, .checked_triangles = 32};

}  // namespace

TEST_CASE("cost split: without its divide a clipper yields what the divide is given") {
  for (const char* scene : {"soup", "soup_straddling", "soup_behind"}) {
    check_bits<Textbook, Skip::divide>(scene, divided);
    check_bits<HomogeneousSutherlandHodgman, Skip::divide>(scene, divided);
    check_bits<HomogeneousPipeline, Skip::divide>(scene, divided);
    check_bits<BlinnNewell, Skip::divide>(scene, divided);
    check_bits<ViewSutherlandHodgman, Skip::divide>(scene, divided);
  }
}

TEST_CASE("cost split: a view-space cut alone yields what the transform is given") {
  for (const char* scene : {"soup", "soup_straddling", "soup_behind"}) {
    check_bits<ViewSutherlandHodgman, Skip::transform_and_divide>(scene, projected);
  }
}

TEST_CASE("cost split: the parts of a round sum to the whole of that round") {
  const auto batches = batches_of("soup");
  const auto contestants = select_contestants("*", {"float", "double"});
  const auto timings = measure_time(batches, contestants, kFew);
  const auto splits = measure_split(batches, contestants, timings, 5);
  CHECK(splits.size() == 8);
  for (const Split& split : splits) {
    REQUIRE(split.parts.size() == 4);
    CHECK(split.parts.back().name == "whole");
    CHECK(split.parts.back().share.median == Approx(100));
    for (std::size_t round = 0; round < 5; ++round) {
      double sum = 0;
      for (std::size_t p = 0; p < 3; ++p) sum += split.parts[p].samples_ns[round];
      CHECK(sum == Approx(split.parts[3].samples_ns[round]));
    }
  }
}

TEST_CASE("cost split: who was not timed has none, nor has who was not asked for") {
  const auto batches = batches_of("soup", 100);
  const auto contestants = select_contestants("homogeneous/sutherland_hodgman", {"float"});
  std::vector<Timing> timings(1);
  CHECK(measure_split(batches, contestants, timings, 3).size() == 1);
  timings[0].refused = "broken";
  CHECK(measure_split(batches, contestants, timings, 3).empty());
}

TEST_CASE("cost: the finding compares the spaces by the rows, and does without what is missing") {
  Table times = cost_table(), operations = cost_operations_table();
  const auto add = [&](const char* clipper, double ns, double count) {
    times.add_row({std::string("soup"), std::string(clipper), std::string("float"), ns, ns, ns, 1.0,
                   1.0, 1.0});
    operations.add_row({std::string("soup"), std::string(clipper), count, count, count, 0.0});
  };
  add("homogeneous/sutherland_hodgman", 10, 4);
  CHECK(cost_finding(times, operations) ==
        "homogeneous/sutherland_hodgman was not compared on soup");
  add("view/sutherland_hodgman", 15, 5);
  CHECK(
      cost_finding(times, operations) ==
      "Against homogeneous/sutherland_hodgman on soup in float: view/sutherland_hodgman takes 1.50 "
      "times the time, 1.25 times the arithmetic, 1.25 times the divisions.");
}

TEST_CASE("timing: tasks run in turn, each once per round, in an order that rotates") {
  std::vector<int> order;
  std::vector<std::function<double()>> tasks;
  for (int i = 0; i < 3; ++i) {
    tasks.push_back([&order, i] {
      order.push_back(i);
      return i + 0.5;
    });
  }
  const auto samples = run_in_turn(tasks, 3);
  CHECK(order == std::vector{0, 1, 2, 1, 2, 0, 2, 0, 1});
  CHECK(samples[1] == std::vector{1.5, 1.5, 1.5});
}

TEST_CASE("timing: batches know the numbers of their triangles in the mesh") {
  const Scene scene = make_builtin_scene("slivers", {.seed = 1, .quick = true});
  for (const TimedBatch& batch : timed_batches(scene, 300)) {
    REQUIRE(batch.numbers.size() == batch.triangles.size());
    for (std::size_t i = 0; i < batch.numbers.size(); ++i) {
      SceneTriangle triangle;
      view_triangles(scene, batch.view, batch.numbers[i], std::span(&triangle, 1));
      REQUIRE(triangle[1].position == batch.triangles[i][1].position);
    }
  }
}

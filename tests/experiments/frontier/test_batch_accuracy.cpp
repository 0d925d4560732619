// SPDX-License-Identifier: GPL-3.0-or-later
//
// Accuracy on timed triangles, and the distance of polygons on screen.
#include <tbb/global_control.h>

#include "experiments/measure/batch_accuracy.hpp"
#include "experiments/measure/screen_distance.hpp"
#include "experiments/scenes/builtin.hpp"
#include "spaces/clippers.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

std::vector<BatchAccuracy> judged(const std::string& scene, const std::string& clipper,
                                  const std::vector<std::string>& scalars,
                                  std::size_t triangles = 300) {
  const auto batches =
      timed_batches(make_builtin_scene(scene, {.seed = 1, .quick = true}), triangles);
  const auto contestants = select_contestants(clipper, scalars);
  Progress progress("", triangles * contestants.size());
  return judge_batches(batches, contestants, progress);
}

// homogeneous/sutherland_hodgman in double with the x of the first vertex moved.
template <int kUnits>
void nudged(const Projection<double>& projection,
            std::span<const ViewTriangle<double, kSceneAttributes>> triangles,
            PolygonStream<double, kSceneAttributes>& out) {
  NdcPolygon<double, kSceneAttributes> polygon;
  for (const auto& triangle : triangles) {
    HomogeneousSutherlandHodgman{}(projection, triangle, polygon);
    if (!polygon.empty()) polygon[0].position[0] += kUnits * 1e-6;
    out.append(polygon);
  }
}

BatchAccuracy judged(const Contestant<double>& contestant, const std::string& scene) {
  const auto batches = timed_batches(make_builtin_scene(scene, {.seed = 1, .quick = true}), 300);
  const std::vector<AnyContestant> contestants = {&contestant};
  Progress progress("", 300);
  return judge_batches(batches, contestants, progress).front();
}

}  // namespace

TEST_CASE("batch accuracy: exact arithmetic is right in every coordinate and has no error") {
  for (const char* scene : {"soup", "soup_straddling", "slivers"}) {
    const BatchAccuracy a = judged(scene, "homogeneous/sutherland_hodgman", {"exact"}).front();
    INFO(scene);
    CHECK(a.visible > 0);
    CHECK(a.wrong == 0);
    CHECK(a.error_px.max() == 0);
    CHECK(a.correctly_rounded == a.coordinates);
  }
}

TEST_CASE("batch accuracy: a double is almost always the right float, a float often is not") {
  const auto a = judged("soup_straddling", "homogeneous/sutherland_hodgman", {"float", "double"});
  CHECK(a[0].correctly_rounded_percent() < 95);
  CHECK(a[1].correctly_rounded_percent() > 99.9);
  CHECK(a[0].coordinates == a[1].coordinates);
}

TEST_CASE("batch accuracy: every timed triangle is judged") {
  const auto batches = timed_batches(make_builtin_scene("teapot", {.seed = 1, .quick = true}), 300);
  std::int64_t timed = 0;
  for (const TimedBatch& batch : batches)
    timed += static_cast<std::int64_t>(batch.triangles.size());
  CHECK(judged("teapot", "textbook", {"float"}).front().triangles == timed);
}

TEST_CASE("batch accuracy: one moved vertex shows in the distance and in the coordinates") {
  const auto* honest = std::get<const Contestant<double>*>(
      find_contestant("homogeneous/sutherland_hodgman", "double"));
  Contestant<double> still = *honest, moved = *honest;
  still.view = nudged<0>;
  moved.view = nudged<1>;
  const BatchAccuracy before = judged(still, "soup_inside"), after = judged(moved, "soup_inside");
  CHECK(before.error_px.max() < 1e-9);
  CHECK(after.error_px.quantile(0.5) == Approx(1e-6 * 3840 / 2).epsilon(0.02));
  CHECK(after.wrong == 0);
  CHECK(before.correctly_rounded - after.correctly_rounded > after.visible * 9 / 10);
}

TEST_CASE("batch accuracy: triangles that are dropped count as wrong, as far as they reach") {
  const BatchAccuracy a = judged("soup_straddling", "whole/any_outside", {"exact"}).front();
  CHECK(a.wrong == a.visible);
  CHECK(a.correctly_rounded == 0);
  CHECK(a.error_px.max() > 10);
}

TEST_CASE("batch accuracy: the same whatever the number of threads") {
  const auto many = judged("slivers", "*", {"float"});
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const auto one = judged("slivers", "*", {"float"});
  for (std::size_t i = 0; i < many.size(); ++i) {
    CHECK(many[i].wrong == one[i].wrong);
    CHECK(many[i].correctly_rounded == one[i].correctly_rounded);
    CHECK(many[i].error_px.max() == one[i].error_px.max());
    CHECK(many[i].worst_triangle == one[i].worst_triangle);
  }
}

TEST_CASE("screen distance: squares side by side, one in the other, and nothing") {
  const std::vector<ScreenPoint> square = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  const std::vector<ScreenPoint> aside = {{3, 0}, {13, 0}, {13, 10}, {3, 10}};
  const std::vector<ScreenPoint> inner = {{2, 2}, {8, 2}, {8, 8}, {2, 8}};
  CHECK(screen_distance(square, square) == 0);
  CHECK(screen_distance(square, aside) == Approx(3));
  CHECK(screen_distance(square, inner) == Approx(std::sqrt(8.0)));
  CHECK(screen_distance(inner, square) == Approx(std::sqrt(8.0)));
  CHECK(screen_distance(square, {}) == Approx(std::sqrt(200.0)));
  CHECK(screen_distance({}, {}) == 0);
}

TEST_CASE("screen distance: one vertex more on an edge changes nothing") {
  const std::vector<ScreenPoint> triangle = {{0, 0}, {10, 0}, {0, 10}};
  const std::vector<ScreenPoint> with_one_more = {{0, 0}, {5, 0}, {10, 0}, {0, 10}};
  CHECK(screen_distance(triangle, with_one_more) == Approx(0).margin(1e-12));
}

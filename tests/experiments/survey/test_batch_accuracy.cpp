// SPDX-License-Identifier: GPL-3.0-or-later
//
// Accuracy on timed triangles, and the distance of polygons on screen.
#include <tbb/global_control.h>

#include "experiments/scenes/builtin.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/survey/batch_accuracy.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/contestants/handmade.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

std::vector<BatchAccuracy> judged(const std::string& scene, const std::string& clipper,
                                  const std::vector<std::string>& scalars,
                                  std::size_t triangles = 300) {
  const auto batches =
      sampled_views(make_builtin_scene(scene, {.seed = 1, .quick = true}), triangles);
  const auto contestants = select_contestants(clipper, scalars);
  Progress progress("", triangles * contestants.size());
  return judge_batches(batches, contestants, progress);
}

BatchAccuracy judged(const Contestant& contestant, const std::string& scene) {
  const auto views = sampled_views(make_builtin_scene(scene, {.seed = 1, .quick = true}), 300);
  Progress progress("", 300);
  return judge_batches(views, {&contestant}, progress).front();
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
  const auto batches = sampled_views(make_builtin_scene("teapot", {.seed = 1, .quick = true}), 300);
  std::int64_t timed = 0;
  for (const SampledView& batch : batches) {
    timed += static_cast<std::int64_t>(batch.triangles.size());
  }
  CHECK(judged("teapot", "textbook", {"float"}).front().triangles == timed);
}

TEST_CASE("batch accuracy: one moved vertex shows in the distance and in the coordinates") {
  const Contestant& still = find_contestant("homogeneous/sutherland_hodgman", "double");
  const Contestant moved = altered(still, [](Numbers& polygon) {
    if (!polygon.empty()) polygon[0][0] += 1e-6;
  });
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

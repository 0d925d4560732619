// SPDX-License-Identifier: GPL-3.0-or-later
//
// The promise checker must let right answers pass and catch answers that are wrong in each way.
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "experiments/judge/promise.hpp"
#include "experiments/scenes/builtin.hpp"
#include "experiments/selection/select.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/contestants/handmade.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

using Vertices = std::vector<NdcVertex<float, kSceneAttributes>>;

// One vertex outside the right plane: the answer has four vertices.
SceneTriangle straddling() {
  SceneTriangle triangle{};
  triangle[0].position = {0, 0, -2};
  triangle[1].position = {3, 0, -2};
  triangle[2].position = {0, 1, -2};
  for (std::size_t i = 0; i < 3; ++i) triangle[i].attributes[static_cast<int>(i)] = 1;
  return triangle;
}

Vertices clipped_by(std::string_view clipper, const SceneTriangle& triangle) {
  View view;
  view.frustum = {};
  const Answers answers = clip(find_contestant(clipper, "float"), batch_of(view, {&triangle, 1}));
  Vertices vertices;
  for (const VertexView& v : answers[0]) {
    auto& vertex = vertices.emplace_back();
    for (int i = 0; i < 4; ++i) vertex.position[i] = static_cast<float>(v.position(i).value);
    for (int k = 0; k < kSceneAttributes; ++k) {
      vertex.attributes[k] = static_cast<float>(v.attribute(k).value);
    }
  }
  return vertices;
}

PromiseCheck check(const Promise& promise, const Vertices& answer, const SceneTriangle& triangle) {
  const PromiseChecker checker{Frustum<double>{}};
  return checker.check(promise, reference::input_triangle(triangle), answer_of(answer)[0]);
}

const Promise kFull{.ulps = 64};

void check_broken(const std::function<void(Vertices&)>& break_it, const std::string& reason) {
  Vertices answer = clipped_by("homogeneous/sutherland_hodgman", straddling());
  REQUIRE(answer.size() == 4);
  REQUIRE(check(kFull, answer, straddling()).verdict == PromiseVerdict::kept);
  break_it(answer);
  const PromiseCheck result = check(kFull, answer, straddling());
  CHECK(result.verdict == PromiseVerdict::broken);
  INFO(result.reason);
  CHECK(result.reason.find(reason) != std::string::npos);
}

}  // namespace

TEST_CASE("promise: a vertex moved off the triangle breaks it") {
  check_broken([](Vertices& v) { v[0].position[2] += 1e-3f; }, "off the triangle");
}

TEST_CASE("promise: a wrong attribute breaks it") {
  check_broken([](Vertices& v) { v[1].attributes[0] += 1e-3f; }, "off the triangle");
}

TEST_CASE("promise: a wrong 1/w breaks it") {
  check_broken([](Vertices& v) { v[1].position[3] *= 1.001f; }, "off the triangle");
}

TEST_CASE("promise: a vertex outside the volume breaks it") {
  check_broken(
      [](Vertices& v) {
        for (auto& vertex : v) {
          if (vertex.position[0] == 1) vertex.position[0] = 1.01f;
        }
      },
      "outside the volume");
}

// x = 0 is the right side of a tile and the left side of the next one.
TEST_CASE("promise: drawing what lies in an open side breaks it") {
  SceneTriangle edge_on{};
  edge_on[0].position = {0, 0, -2};
  edge_on[1].position = {0, 0.5f, -2};
  edge_on[2].position = {0, 0, -4};
  const auto verdict_in = [&](const Frustum<float>& tile, const OpenSides& asked) {
    View view;
    view.frustum = tile;
    Batch batch = batch_of(view, {&edge_on, 1});
    batch.volume.open_sides = asked;
    const Answers answers = clip(find_contestant("homogeneous/sutherland_hodgman", "exact"), batch);
    batch.volume.open_sides = true;
    const Promise promise = find_contestant("homogeneous/sutherland_hodgman", "exact").promise;
    return PromiseChecker(batch)
        .check(promise, reference::input_triangle(edge_on), answers[0])
        .verdict;
  };
  CHECK(verdict_in({.right = 0}, true) == PromiseVerdict::kept);
  CHECK(verdict_in({.left = 0}, true) == PromiseVerdict::kept);
  CHECK(verdict_in({.right = 0}, {}) == PromiseVerdict::broken);
  CHECK(verdict_in({.left = 0}, OpenSides(true, false, false, false)) == PromiseVerdict::broken);
}

TEST_CASE("promise: a lost corner breaks it") {
  check_broken([](Vertices& v) { v.pop_back(); }, "was not drawn");
}

TEST_CASE("promise: drawing nothing of something visible breaks it") {
  check_broken([](Vertices& v) { v.clear(); }, "nothing was drawn");
}

TEST_CASE("promise: a coordinate that is not finite breaks it") {
  check_broken([](Vertices& v) { v[0].position[0] = HUGE_VALF; }, "not finite");
}

TEST_CASE("promise: cvv/naive breaks it in front of the eye by its attributes alone") {
  SceneTriangle deep = straddling();
  deep[0].position = {-1, 0, -9};
  const Vertices answer = clipped_by("cvv/naive", deep);
  Promise promise = kFull;
  promise.amplification = Promise::Amplification::w_ratio;
  CHECK(check(promise, answer, deep).verdict == PromiseVerdict::broken);
  promise.attributes = false;
  CHECK(check(promise, answer, deep).verdict == PromiseVerdict::kept);
}

TEST_CASE("promise: dropping straddling triangles loses what full coverage would promise") {
  const Promise promise = find_contestant("any_outside", "float").promise;
  CHECK(check(promise, {}, straddling()).verdict == PromiseVerdict::kept);
  Promise more = promise;
  more.covers = true;
  CHECK(check(more, {}, straddling()).verdict == PromiseVerdict::broken);
}

TEST_CASE("promise: triangles behind the near plane are outside the domain of a divide first") {
  SceneTriangle behind = straddling();
  behind[2].position = {0, 1, 2};
  const Promise promise = find_contestant("cvv/perspective", "float").promise;
  CHECK(check(promise, clipped_by("cvv/perspective", behind), behind).verdict ==
        PromiseVerdict::outside_domain);
  // And rightly so: the same answer breaks a promise for any triangle.
  CHECK(check(kFull, clipped_by("cvv/perspective", behind), behind).verdict ==
        PromiseVerdict::broken);
}

TEST_CASE("promise: every clipper keeps its own on every built-in scene, in every scalar") {
  for (const SceneInfo& info : builtin_scenes()) {
    const Scene scene = make_builtin_scene(info.name, {.seed = 2, .quick = true});
    const View& view = scene.views.back();
    const PromiseChecker checker(frustum_cast<double>(view.frustum));
    const Spacing spacing = spacing_of(scene, 60);
    const auto triangles = sampled_view_triangles(scene, view, spacing, 0, spacing.count);
    const Batch batch = batch_of(view, triangles);
    for (const Contestant& contestant : all_contestants()) {
      if (contestant.contract != Contract::full || !contestant.takes(batch)) continue;
      const Answers answers = clip(contestant, batch);
      for (std::size_t i = 0; i < triangles.size(); ++i) {
        const auto result =
            checker.check(contestant.promise, reference::input_triangle(triangles[i]), answers[i]);
        INFO(info.name << " " << name_of(contestant) << " triangle " << i << ": " << result.reason);
        CHECK(result.verdict != PromiseVerdict::broken);
      }
    }
  }
}

TEST_CASE("promise: who promises correct rounding must have every bit right") {
  const Promise& promise = find_contestant("correctly_rounded", "float").promise;
  REQUIRE(promise.correctly_rounded);
  const SceneTriangle triangle = straddling();
  const Vertices right = clipped_by("correctly_rounded", triangle);
  CHECK(check(promise, right, triangle).verdict == PromiseVerdict::kept);
  for (int i = 0; i < 4 + kSceneAttributes; ++i) {
    Vertices wrong = right;
    float& number = i < 4 ? wrong[1].position[i] : wrong[1].attributes[i - 4];
    number = std::nextafter(number, 2.0f);
    const PromiseCheck result = check(promise, wrong, triangle);
    INFO(i << ": " << result.reason);
    CHECK(result.verdict == PromiseVerdict::broken);
    CHECK(result.reason.find("not correctly rounded: vertex 1") != std::string::npos);
  }
  CHECK(check(promise, {}, triangle).verdict == PromiseVerdict::broken);
  CHECK(check(promise, {right[0], right[1], right[2]}, triangle).verdict == PromiseVerdict::broken);
}

TEST_CASE("promise: floats that are merely good are not correctly rounded") {
  Promise boast = kFull;
  boast.correctly_rounded = true;
  std::mt19937_64 random(3);
  int broken = 0;
  for (int n = 0; n < 100; ++n) {
    SceneTriangle triangle = straddling();
    for (auto& v : triangle) {
      for (int i = 0; i < 3; ++i) v.position[i] += static_cast<float>(random() % 1000) * 1e-3f;
    }
    const Vertices answer = clipped_by("homogeneous/sutherland_hodgman", triangle);
    broken += check(boast, answer, triangle).verdict == PromiseVerdict::broken ? 1 : 0;
  }
  CHECK(broken > 50);
}

namespace {

// Of the answer of a chain in float, which must not break its promise.
PromiseVerdict verdict_in(const Frustum<float>& frustum, const SceneTriangle& triangle) {
  View view;
  view.frustum = frustum;
  const Batch batch = batch_of(view, {&triangle, 1});
  const Contestant& clipper = find_contestant("homogeneous/sutherland_hodgman", "float");
  const PromiseCheck result = PromiseChecker(batch).check(
      clipper.promise, reference::input_triangle(triangle), clip(clipper, batch)[0]);
  INFO(result.reason);
  CHECK(result.verdict != PromiseVerdict::broken);
  return result.verdict;
}

}  // namespace

TEST_CASE(
    "promise: it speaks of small frusta as long as what they need are normal numbers, and is kept") {
  SceneTriangle triangle{};
  triangle[0].position = {0, 0, -0x1p-75f};
  triangle[1].position = {0x1.8p-19f, 0, -0x1p-75f};
  triangle[2].position = {0, 0x1p-21f, -0x1p-75f};
  const Frustum<float> small{.left = -0x1p-21f,  // near far is no normal number
                             .right = 0x1p-21f,
                             .bottom = -0x1p-21f,
                             .top = 0x1p-21f,
                             .near = 0x1p-76f,
                             .far = 0x1.8p-74f,
                             .depth = DepthRange::reversed};
  CHECK(verdict_in(small, triangle) == PromiseVerdict::kept);
  Frustum<float> wide = small;
  wide.right = 0x1p+60f;  // 2 near / (right - left) is none
  CHECK(verdict_in(wide, triangle) == PromiseVerdict::outside_domain);
  wide.right = 0x1p-10f;  // the square of right / near is beyond all floats
  CHECK(verdict_in(wide, triangle) == PromiseVerdict::outside_domain);
  Frustum<float> nearer = small;
  nearer.near = 0x1p-130f;
  CHECK(verdict_in(nearer, triangle) == PromiseVerdict::outside_domain);
  // A side's number times a coordinate is none, on which planes in view space depend.
  SceneTriangle tiny = straddling();
  for (auto& v : tiny) {
    for (int i = 0; i < 3; ++i) v.position[i] *= 0x1p-120f;
  }
  const float side = 0x1p-120f;
  const Frustum<float> narrow{
      .left = -side, .right = side, .bottom = -side, .top = side, .near = side, .far = 8 * side};
  CHECK(verdict_in(narrow, tiny) == PromiseVerdict::outside_domain);
}

TEST_CASE("promise: it speaks of frusta up to the largest floats, but not of sums beyond them") {
  const SceneTriangle triangle = straddling();
  CHECK(verdict_in({.far = 0x1.fffffep+127f}, triangle) == PromiseVerdict::kept);
  CHECK(verdict_in({.near = 0x1p+110f, .far = 0x1.fffffep+127f}, triangle) ==
        PromiseVerdict::outside_domain);
  CHECK(verdict_in({.left = -0x1p+127f, .right = 0x1.8p+127f}, triangle) ==
        PromiseVerdict::outside_domain);
}

// Subnormal numbers have fewer bits than others: the bound has a smallest number beside u M.
TEST_CASE("promise: an attribute may be off by as many of the smallest numbers, not more") {
  SceneTriangle triangle = straddling();
  for (std::size_t i = 0; i < 3; ++i) triangle[i].attributes[static_cast<int>(i)] = 0x1p-140f;
  Vertices answer = clipped_by("homogeneous/sutherland_hodgman", triangle);
  CHECK(check(kFull, answer, triangle).verdict == PromiseVerdict::kept);
  answer[1].attributes[3] += 60 * 0x1p-149f;
  CHECK(check(kFull, answer, triangle).verdict == PromiseVerdict::kept);
  answer[1].attributes[3] += 60 * 0x1p-149f;
  CHECK(check(kFull, answer, triangle).verdict == PromiseVerdict::broken);
}

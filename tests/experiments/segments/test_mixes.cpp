// SPDX-License-Identifier: GPL-3.0-or-later
//
// The mixes of segments: repeatable, and what their names say.
#include <algorithm>
#include <set>

#include "experiments/judge/cycle.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/scenes/builtin.hpp"
#include "experiments/segments/mixes.hpp"
#include "reference/exact_clip.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::segments;
using reference::Verdict;

namespace {

reference::Truth truth_of(const SegmentView& v) {
  return reference::Truth::of_frustum(frustum_cast<double>(v.view.frustum));
}

bool same_bits(const Mix& a, const Mix& b) {
  return std::ranges::equal(numbers_of(std::span(a.views.front().segments)),
                            numbers_of(std::span(b.views.front().segments)),
                            [](float x, float y) { return same_number(x, y, Likeness::by_bits); });
}

// Whether an end is inside, by the reference's own verdict on a point.
std::array<bool, 2> inside_ends(const reference::Truth& truth,
                                std::span<const reference::InputVertex> ends) {
  const auto is_inside = [&](std::size_t i) {
    return reference::clip(truth, ends.subspan(i, 1), 0).vertices.size() == 1;
  };
  return {is_inside(0), is_inside(1)};
}

}  // namespace

TEST_CASE("segment mixes: a seed gives the same bits again, another seed gives others") {
  for (const std::string& name : builtin_mixes()) {
    INFO(name);
    const Mix mix = make_mix(name, 50, 7);
    REQUIRE(mix.views.size() == 1);
    CHECK(mix.views.front().segments.size() == 50);
    CHECK(same_bits(mix, make_mix(name, 50, 7)));
    CHECK_FALSE(same_bits(mix, make_mix(name, 50, 8)));
  }
  CHECK_THROWS_AS(make_mix("no_such_mix", 1, 1), UsageError);
}

TEST_CASE("segment mixes: each class holds what its name says, in exact arithmetic") {
  for (const std::string name : {"inside", "outside", "cross_one", "cross_several", "cross_w0"}) {
    const SegmentView made = make_mix(name, 200, 3).views.front();
    const Batch batch = made.batch();
    const reference::Truth truth = truth_of(made);
    REQUIRE(batch.size() == 200);
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const auto ends = input_vertices(batch, i);
      const auto [first, second] = inside_ends(truth, ends);
      const auto exact = reference::clip(truth, ends, kSceneAttributes);
      const bool passes_eye = ends[0].position[2] > 0 || ends[1].position[2] > 0;
      INFO(name);
      if (name == "inside") CHECK(exact.verdict == Verdict::accepted);
      if (name == "outside") CHECK(reference::classify(truth, ends, 0) == Verdict::rejected);
      if (name == "cross_one" || name == "cross_w0") CHECK(first != second);
      if (name == "cross_several") CHECK((exact.vertices.size() == 2 && !(first && second)));
      if (name == "cross_w0") CHECK(passes_eye);
      if (name == "cross_several") CHECK_FALSE(passes_eye);
    }
  }
}

TEST_CASE("segment mixes: the smaller the window, the more is rejected; a large one accepts most") {
  const auto share = [](std::string_view name, Facts::Kind kind) {
    const SegmentView made = make_mix(name, 400, 5).views.front();
    const reference::Truth truth = truth_of(made);
    return std::ranges::count_if(
        made.segments, [&](const SceneSegment& s) { return facts_of(truth, s).kind == kind; });
  };
  CHECK(share("window_1_64", Facts::rejected) > share("window_1_8", Facts::rejected));
  CHECK(share("window_1_8", Facts::rejected) > share("window_1_1", Facts::rejected));
  CHECK(share("window_4_1", Facts::accepted) > share("window_1_1", Facts::accepted));
  CHECK(share("window_4_1", Facts::accepted) > 300);
}

TEST_CASE("segment mixes: facts tell an end on a plane from one beyond it") {
  const Frustum<float> frustum;  // sides at 45 degrees, near 1
  const auto truth = reference::Truth::of_frustum(frustum_cast<double>(frustum));
  SceneSegment segment{};
  segment[0].position = {0, 0, -2};
  segment[1].position = {2, 0, -2};
  CHECK(facts_of(truth, segment).kind == Facts::accepted);
  segment[1].position[0] = std::nextafter(2.0f, 3.0f);
  const Facts beyond = facts_of(truth, segment);
  CHECK(beyond.kind == Facts::shortened);
  CHECK(beyond.ends_outside == 1);
  CHECK(beyond.crossings == 1);
  segment[0].position = {3, 0, -3};  // touches the plane in a point
  CHECK(facts_of(truth, segment).kind == Facts::rejected);
}

TEST_CASE("segment mixes: a wireframe has each edge of the mesh once per view") {
  const Scene scene = make_builtin_scene("floor", {.seed = 1, .quick = true});
  const Mix mix = make_wireframe(scene, 100000);
  CHECK(mix.name == "wireframe floor");
  REQUIRE(mix.views.size() == scene.views.size());
  // A sheet of 4 x 4 quads: 2 * 4 * 5 sides and 16 diagonals.
  CHECK(mix.views.front().segments.size() == 56);
  std::set<std::array<float, 6>> seen;
  for (const SceneSegment& s : mix.views.front().segments) {
    const auto& a = s[0].position;
    const auto& b = s[1].position;
    CHECK(seen.insert({a[0], a[1], a[2], b[0], b[1], b[2]}).second);
    CHECK(seen.insert({b[0], b[1], b[2], a[0], a[1], a[2]}).second);
  }
  std::size_t few = 0;
  for (const SegmentView& v : make_wireframe(scene, 60).views) few += v.segments.size();
  CHECK(few <= 60);
}

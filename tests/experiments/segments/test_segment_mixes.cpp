// SPDX-License-Identifier: GPL-3.0-or-later
//
// The mixes of segments: repeatable, and what their names say.
#include <algorithm>
#include <set>

#include "experiments/errors.hpp"
#include "experiments/scenes/builtin.hpp"
#include "experiments/segments/mixes.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using reference::Verdict;

namespace {

reference::Truth truth_of(const SegmentBatch& batch) {
  return reference::Truth::of_frustum(frustum_cast<double>(batch.view.frustum));
}

bool same_bits(const SegmentMix& a, const SegmentMix& b) {
  return std::ranges::equal(
      a.batches.front().segments, b.batches.front().segments, [](const auto& s, const auto& t) {
        return s[0].position == t[0].position && s[1].position == t[1].position &&
               s[0].attributes.values == t[0].attributes.values;
      });
}

// Whether an end is inside, by the reference's own verdict on a point.
std::array<bool, 2> inside_ends(const reference::Truth& truth, const SceneSegment& segment) {
  const auto ends = input_segment(segment);
  const auto is_inside = [&](std::size_t i) {
    return reference::clip(truth, std::span(ends).subspan(i, 1), 0).vertices.size() == 1;
  };
  return {is_inside(0), is_inside(1)};
}

}  // namespace

TEST_CASE("segment mixes: a seed gives the same bits again, another seed gives others") {
  for (const std::string& name : builtin_mixes()) {
    INFO(name);
    const SegmentMix mix = make_mix(name, 50, 7);
    CHECK(mix.size() == 50);
    CHECK(same_bits(mix, make_mix(name, 50, 7)));
    CHECK_FALSE(same_bits(mix, make_mix(name, 50, 8)));
  }
  CHECK_THROWS_AS(make_mix("no_such_mix", 1, 1), UsageError);
}

TEST_CASE("segment mixes: each class holds what its name says, in exact arithmetic") {
  for (const std::string name : {"inside", "outside", "cross_one", "cross_several", "cross_w0"}) {
    const SegmentBatch batch = make_mix(name, 200, 3).batches.front();
    const reference::Truth truth = truth_of(batch);
    for (const SceneSegment& segment : batch.segments) {
      const auto ends = input_segment(segment);
      const auto [first, second] = inside_ends(truth, segment);
      const auto exact = reference::clip(truth, ends, kSceneAttributes);
      const bool passes_eye = segment[0].position[2] > 0 || segment[1].position[2] > 0;
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
  const auto share = [](std::string_view name, SegmentFacts::Kind kind) {
    const SegmentBatch batch = make_mix(name, 400, 5).batches.front();
    const reference::Truth truth = truth_of(batch);
    return std::ranges::count_if(
        batch.segments, [&](const SceneSegment& s) { return facts_of(truth, s).kind == kind; });
  };
  using Kind = SegmentFacts::Kind;
  CHECK(share("window_1_64", Kind::rejected) > share("window_1_8", Kind::rejected));
  CHECK(share("window_1_8", Kind::rejected) > share("window_1_1", Kind::rejected));
  CHECK(share("window_4_1", Kind::accepted) > share("window_1_1", Kind::accepted));
  CHECK(share("window_4_1", Kind::accepted) > 300);
}

TEST_CASE("segment mixes: facts tell an end on a plane from one beyond it") {
  const Frustum<float> frustum;  // sides at 45 degrees, near 1
  const auto truth = reference::Truth::of_frustum(frustum_cast<double>(frustum));
  SceneSegment segment{};
  segment[0].position = {0, 0, -2};
  segment[1].position = {2, 0, -2};
  CHECK(facts_of(truth, segment).kind == SegmentFacts::Kind::accepted);
  segment[1].position[0] = std::nextafter(2.0f, 3.0f);
  const SegmentFacts beyond = facts_of(truth, segment);
  CHECK(beyond.kind == SegmentFacts::Kind::shortened);
  CHECK(beyond.ends_outside == 1);
  CHECK(beyond.crossings == 1);
  segment[0].position = {3, 0, -3};  // touches the plane in a point
  CHECK(facts_of(truth, segment).kind == SegmentFacts::Kind::rejected);
}

TEST_CASE("segment mixes: a wireframe has each edge of the mesh once per view") {
  const Scene scene = make_builtin_scene("floor", {.seed = 1, .quick = true});
  const SegmentMix mix = make_wireframe(scene, 100000);
  REQUIRE(mix.batches.size() == scene.views.size());
  // A sheet of 4 x 4 quads: 2 * 4 * 5 sides and 16 diagonals.
  CHECK(mix.batches.front().segments.size() == 56);
  std::set<std::array<float, 6>> seen;
  for (const SceneSegment& s : mix.batches.front().segments) {
    const auto& a = s[0].position;
    const auto& b = s[1].position;
    CHECK(seen.insert({a[0], a[1], a[2], b[0], b[1], b[2]}).second);
    CHECK(seen.insert({b[0], b[1], b[2], a[0], a[1], a[2]}).second);
  }
  CHECK(make_wireframe(scene, 60).size() <= 60);
}

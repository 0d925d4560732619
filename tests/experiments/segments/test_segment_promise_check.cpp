// SPDX-License-Identifier: GPL-3.0-or-later
//
// The promise checker of segments must let right answers pass and catch what is wrong.
#include <cmath>
#include <functional>
#include <vector>

#include "experiments/measure/batches.hpp"
#include "experiments/segments/mixes.hpp"
#include "experiments/segments/promise_check.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

constexpr int K = kSceneAttributes;
using Vertices = std::vector<NdcVertex<float, K>>;

const Promise kFull{.ulps = 64};

// Out by the right plane of the default frustum.
SceneSegment crossing() {
  SceneSegment segment{};
  segment[0].position = {-1, 0, -2};
  segment[1].position = {5, 1, -4};
  segment[0].attributes[0] = 1;
  segment[1].attributes[1] = 1;
  return segment;
}

Vertices answer_of(std::string_view clipper, const SceneSegment& segment) {
  const auto* contestant =
      std::get<const Contestant<float, 2>*>(find_contestant<2>(clipper, "float"));
  PolygonStream<float, K> out;
  contestant->view(Projection<float>(Frustum<float>{}), std::span(&segment, 1), out);
  return {out[0].begin(), out[0].end()};
}

PromiseCheck check(const Promise& promise, const Vertices& answer, const SceneSegment& segment) {
  const SegmentPromiseChecker checker{Frustum<double>{}};
  return checker.check<float, K>(promise, input_segment(segment), K, answer);
}

void check_broken(const std::function<void(Vertices&)>& break_it, const std::string& reason) {
  Vertices answer = answer_of("homogeneous/liang_barsky", crossing());
  REQUIRE(answer.size() == 2);
  REQUIRE(check(kFull, answer, crossing()).verdict == PromiseVerdict::kept);
  break_it(answer);
  const PromiseCheck result = check(kFull, answer, crossing());
  INFO(result.reason);
  CHECK(result.verdict == PromiseVerdict::broken);
  CHECK(result.reason.find(reason) != std::string::npos);
}

}  // namespace

TEST_CASE("segment promise: an end moved off the segment breaks it") {
  check_broken([](Vertices& v) { v[0].position[2] += 1e-3f; }, "off the segment");
}

TEST_CASE("segment promise: a wrong 1/w or attribute breaks it") {
  check_broken([](Vertices& v) { v[1].position[3] *= 1.001f; }, "off the segment");
  check_broken([](Vertices& v) { v[1].attributes[0] += 1e-3f; }, "off the segment");
}

TEST_CASE("segment promise: an end beyond the plane breaks it") {
  // The input's own end lies on the segment, but outside the volume.
  check_broken(
      [](Vertices& v) {
        v[1] = {{1.25f, 0.25f, v[1].position[2], 0.25f}, {{0, 1, 0, 0}}};
      },
      "");
  Vertices whole = answer_of("homogeneous/liang_barsky", crossing());
  Promise loose = kFull;
  loose.contained = loose.attributes = false;
  const auto projected =
      to_ndc(to_clip(Projection<float>(Frustum<float>{}), crossing()[1].position));
  whole[1].position = projected;
  CHECK(check(loose, whole, crossing()).verdict == PromiseVerdict::kept);
  loose.contained = true;
  const PromiseCheck outside = check(loose, whole, crossing());
  CHECK(outside.verdict == PromiseVerdict::broken);
  CHECK(outside.reason.find("outside the volume") != std::string::npos);
}

TEST_CASE("segment promise: a segment that was shortened too much breaks it") {
  check_broken([](Vertices& v) { v[1] = v[0]; }, "not drawn");
  check_broken([](Vertices& v) { v.clear(); }, "nothing was drawn");
}

TEST_CASE("segment promise: one vertex, or one that is not finite, breaks it") {
  check_broken([](Vertices& v) { v.pop_back(); }, "1 vertices");
  check_broken([](Vertices& v) { v[0].position[0] = NAN; }, "not finite");
}

TEST_CASE("segment promise: across w = 0 the naive divide is outside its domain, and rightly so") {
  SceneSegment behind = crossing();
  behind[1].position[2] = 3;
  const Vertices answer = answer_of("cvv/liang_barsky_naive", behind);
  const Promise own =
      std::get<const Contestant<float, 2>*>(find_contestant<2>("cvv/liang_barsky_naive", "float"))
          ->promise;
  CHECK(check(own, answer, behind).verdict == PromiseVerdict::outside_domain);
  CHECK(check(kFull, answer, behind).verdict == PromiseVerdict::broken);
}

TEST_CASE("segment promise: every clipper keeps its own on every mix, in every scalar") {
  for (const std::string& name : builtin_mixes()) {
    const SegmentBatch batch = make_mix(name, 20, 2).batches.front();
    const SegmentPromiseChecker checker(frustum_cast<double>(batch.view.frustum));
    for_each_type(AllScalars{}, [&]<class T>() {
      for (const Contestant<T, 2>& contestant : contestants<T, 2>()) {
        PolygonStream<T, K> out;
        contestant.view(projection_of<T>(batch.view), simplices_cast<T>(batch.segments), out);
        for (std::size_t i = 0; i < batch.segments.size(); ++i) {
          const PromiseCheck result =
              checker.check<T, K>(contestant.promise, input_segment(batch.segments[i]), K, out[i]);
          INFO(name << " " << contestant.name << " " << ScalarTraits<T>::name << " segment " << i
                    << ": " << result.reason);
          CHECK(result.verdict != PromiseVerdict::broken);
        }
      }
    });
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The promise checker of segments must let right answers pass and catch what is wrong.
#include <cmath>
#include <functional>
#include <vector>

#include "experiments/judge/promise.hpp"
#include "spaces/clippers.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/contestants/handmade.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

constexpr int K = kSceneAttributes;
using Segment = ViewSegment<float, K>;
using Vertices = std::vector<NdcVertex<float, K>>;

const Promise kFull{.ulps = 64};

// Out by the right plane of the default frustum.
Segment crossing() {
  Segment segment{};
  segment[0].position = {-1, 0, -2};
  segment[1].position = {5, 1, -4};
  segment[0].attributes[0] = 1;
  segment[1].attributes[1] = 1;
  return segment;
}

template <class Clipper>
Vertices clipped_by(const Clipper& clipper, const Segment& segment) {
  NdcPolygon<float, K> out;
  clipper(Projection<float>(Frustum<float>{}), segment, out);
  return {out.begin(), out.end()};
}

PromiseCheck check(const Promise& promise, const Vertices& answer, const Segment& segment) {
  const std::array ends = {reference::input_vertex(segment[0]),
                           reference::input_vertex(segment[1])};
  return PromiseChecker(Frustum<double>{}).check(promise, ends, K, answer_of(answer)[0]);
}

void check_broken(const std::function<void(Vertices&)>& break_it, const std::string& reason) {
  Vertices answer = clipped_by(HomogeneousLiangBarsky{}, crossing());
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
  Vertices whole = clipped_by(HomogeneousLiangBarsky{}, crossing());
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
  Segment behind = crossing();
  behind[1].position[2] = 3;
  const Vertices answer = clipped_by(CvvLiangBarskyNaive{}, behind);
  CHECK(check(CvvLiangBarskyNaive::promise, answer, behind).verdict ==
        PromiseVerdict::outside_domain);
  CHECK(check(kFull, answer, behind).verdict == PromiseVerdict::broken);
}

TEST_CASE("segment promise: without a bound floats are outside the domain, exact numbers judged") {
  const Promise unbounded{.ulps = kUnbounded};
  Vertices answer = clipped_by(HomogeneousLiangBarsky{}, crossing());
  CHECK(check(unbounded, answer, crossing()).verdict == PromiseVerdict::outside_domain);

  ViewSegment<Exact, K> exact{};
  for (std::size_t i = 0; i < 2; ++i) {
    for (int c = 0; c < 3; ++c) exact[i].position[c] = Exact(crossing()[i].position[c]);
    for (int k = 0; k < K; ++k) exact[i].attributes[k] = Exact(crossing()[i].attributes[k]);
  }
  NdcPolygon<Exact, K> out;
  HomogeneousLiangBarsky{}(Projection<Exact>(Frustum<Exact>{}), exact, out);
  const std::array ends = {reference::input_vertex(crossing()[0]),
                           reference::input_vertex(crossing()[1])};
  const auto judged = [&] {
    const std::vector<NdcVertex<Exact, K>> vertices(out.begin(), out.end());
    return PromiseChecker(Frustum<double>{}).check(unbounded, ends, K, answer_of(vertices)[0]);
  };
  CHECK(judged().verdict == PromiseVerdict::kept);
  out[0].position[2] += Exact(1e-9);
  CHECK(judged().verdict == PromiseVerdict::broken);
}

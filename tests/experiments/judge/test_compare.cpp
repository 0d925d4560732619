// SPDX-License-Identifier: GPL-3.0-or-later
//
// Outcomes: answers made by hand against the exact one.
#include <cmath>
#include <limits>
#include <vector>

#include "experiments/judge/compare.hpp"
#include "experiments/scenes/scene.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/contestants/handmade.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

using Vertices = std::vector<NdcVertex<float, kSceneAttributes>>;

// A triangle inside the volume, w = 1: the answer is the input.
const Vertices kAnswer = {{{-0.5f, -0.5f, 0.25f, 1}, {{0, 0, 1, 1}}},
                          {{0.5f, -0.5f, 0.25f, 1}, {{1, 0, 1, 1}}},
                          {{0.0f, 0.5f, 0.25f, 1}, {{0, 1, 1, 1}}}};

TruthPolygon truth_of(const Vertices& vertices) {
  reference::InputTriangle triangle;
  triangle.attribute_count = kSceneAttributes;
  for (std::size_t i = 0; i < 3; ++i) {
    for (int c = 0; c < 4; ++c) {
      triangle.vertices[i].position[static_cast<std::size_t>(c)] = vertices[i].position[c];
    }
    for (int k = 0; k < kSceneAttributes; ++k) {
      triangle.vertices[i].attributes[static_cast<std::size_t>(k)] = vertices[i].attributes[k];
    }
  }
  return truth_polygon(reference::Truth::of_clip(DepthRange::minus_one_to_one), triangle);
}

Comparison judge(const Vertices& answer, const Vertices& input = kAnswer) {
  return compare(answer_of(answer)[0], truth_of(input));
}

Vertices moved(float x) {
  Vertices answer = kAnswer;
  answer[1].position[0] = x;
  return answer;
}

const Vertices kOutside = {{{2, 0, 0, 1}, {}}, {{3, 0, 0, 1}, {}}, {{2, 1, 0, 1}, {}}};

}  // namespace

TEST_CASE("compare: the right answer is exact, wherever it begins") {
  CHECK(judge(kAnswer).outcome == Outcome::exact);
  CHECK(judge({kAnswer[2], kAnswer[0], kAnswer[1]}).outcome == Outcome::exact);
  CHECK(judge(kAnswer).position_px == 0);
  CHECK(judge(kAnswer).visible);
}

TEST_CASE("compare: a repeated vertex counts once") {
  CHECK(judge({kAnswer[0], kAnswer[0], kAnswer[1], kAnswer[2], kAnswer[0]}).outcome ==
        Outcome::exact);
}

TEST_CASE("compare: vertices that rounding brings to one place are not repeated ones") {
  // The places of the first two differ by less than a float can tell.
  const float x = std::nextafter(1.0f, 2.0f), w = std::nextafter(3.0f, 4.0f);
  const Vertices input = {{{1, 1, 0, 3}, {}}, {{x, x, 0, w}, {}}, {{0, -1, 0, 3}, {}}};
  Vertices answer = input;
  for (auto& v : answer) {
    const float divisor = v.position[3];
    for (int i = 0; i < 3; ++i) v.position[i] /= divisor;
    v.position[3] = 1 / divisor;
  }
  REQUIRE(answer[0].position[0] == answer[1].position[0]);
  CHECK(judge({answer[1], answer[2], answer[0]}, input).outcome == Outcome::exact);
  const Answers turned = answer_of(Vertices{answer[1], answer[2], answer[0]});
  const auto matched = matched_vertices(turned[0], truth_of(input));
  REQUIRE(matched.has_value());
  REQUIRE(matched->size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK((*matched)[i][1].value == answer[i].position[1]);
    CHECK((*matched)[i][3].value == answer[i].position[3]);
  }
  CHECK(judge({answer[1], answer[2], answer[1]}, input).outcome == Outcome::faithful);
  CHECK(judge({answer[0], answer[2]}, input).outcome == Outcome::missing);
  answer[2].position[0] = 0.25f;
  CHECK(judge({answer[1], answer[2], answer[0]}, input).outcome == Outcome::missing);
}

TEST_CASE("compare: one ulp is faithful, more is subpixel, 1/256 px is visible") {
  const float one_ulp = std::nextafter(0.5f, 1.0f);
  const Comparison faithful = judge(moved(one_ulp));
  CHECK(faithful.outcome == Outcome::faithful);
  CHECK(faithful.position_ulp == 1.0);
  CHECK(faithful.position_px == Approx((one_ulp - 0.5f) * 1920.0));
  CHECK(judge(moved(0.5f + 0x1p-22f)).outcome == Outcome::subpixel);
  CHECK(judge(moved(0.5f + 0.0000021f)).outcome == Outcome::visible);
}

TEST_CASE("compare: another number of vertices is an outcome of its own") {
  Vertices four = kAnswer;
  four.push_back({{-0.4f, 0.1f, 0.25f, 1}, {{0, 0.5f, 1, 1}}});
  CHECK(judge(four).outcome == Outcome::vertex_count);
}

TEST_CASE("compare: nothing for something is missing, something for nothing is extra") {
  CHECK(judge({}).outcome == Outcome::missing);
  CHECK(judge({kAnswer[0], kAnswer[0], kAnswer[1]}).outcome == Outcome::missing);
  CHECK(judge(kAnswer, kOutside).outcome == Outcome::extra);
  const Comparison nothing = judge({}, kOutside);
  CHECK(nothing.outcome == Outcome::exact);
  CHECK_FALSE(nothing.visible);
}

TEST_CASE("compare: a reversed winding is flipped") {
  CHECK(judge({kAnswer[2], kAnswer[1], kAnswer[0]}).outcome == Outcome::flipped);
}

TEST_CASE("compare: NaN and infinity are not finite, in attributes too") {
  CHECK(judge(moved(std::numeric_limits<float>::quiet_NaN())).outcome == Outcome::not_finite);
  CHECK(judge(moved(std::numeric_limits<float>::infinity())).outcome == Outcome::not_finite);
  Vertices answer = kAnswer;
  answer[0].attributes[3] = std::numeric_limits<float>::quiet_NaN();
  CHECK(judge(answer).outcome == Outcome::not_finite);
}

TEST_CASE("compare: attribute errors are absolute") {
  Vertices answer = kAnswer;
  answer[2].attributes[1] = 0.75f;
  CHECK(judge(answer).attribute == 0.25);
  CHECK(judge(answer).outcome == Outcome::exact);
}

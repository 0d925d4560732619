// SPDX-License-Identifier: GPL-3.0-or-later
//
// How many numbers are the nearest: answers made by hand against a triangle whose coordinates are
// thirds.
#include "experiments/judge/rounding_count.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "experiments/judge/equal_numbers.hpp"
#include "experiments/scenes/scene.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/contestants/handmade.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

template <class T>
using Answer = std::vector<NdcVertex<T, 1>>;

// Within the volume: (1, 1, 1, 3), (-1, 1, 1, 3) and (-1, -1, 1, 3) in clip space, with the
// attributes 0, 1 and 2.
template <class T>
Answer<T> nearest_answer() {
  const T third = T(1) / T(3);
  return {{{third, third, third, third}, {{T(0)}}},
          {{-third, third, third, third}, {{T(1)}}},
          {{-third, -third, third, third}, {{T(2)}}}};
}

TruthPolygon thirds() {
  reference::InputTriangle triangle;
  triangle.attribute_count = 1;
  const double x[] = {1, -1, -1}, y[] = {1, 1, -1};
  for (std::size_t i = 0; i < 3; ++i) {
    triangle.vertices[i].position = {x[i], y[i], 1, 3};
    triangle.vertices[i].attributes[0] = static_cast<double>(i);
  }
  return truth_polygon(reference::Truth::of_clip(DepthRange::minus_one_to_one), triangle);
}

template <class T>
RoundingCount count(const Answer<T>& answer, const TruthPolygon& truth = thirds()) {
  return NearestPolygon(truth).count(answer_of(answer)[0]);
}

}  // namespace

TEMPLATE_TEST_CASE("rounding: the nearest numbers are right, wherever the polygon begins", "",
                   float, double) {
  Answer<TestType> answer = nearest_answer<TestType>();
  CHECK(count(answer) == RoundingCount{12, 0, 3, 0});
  std::rotate(answer.begin(), answer.begin() + 1, answer.end());
  CHECK(count(answer) == RoundingCount{12, 0, 3, 0});
  answer.push_back(answer.back());
  CHECK(count(answer) == RoundingCount{12, 0, 3, 0});
}

TEMPLATE_TEST_CASE("rounding: a number one ulp away is misrounded", "", float, double) {
  Answer<TestType> answer = nearest_answer<TestType>();
  answer[2].position[1] = std::nextafter(answer[2].position[1], TestType(0));
  CHECK(count(answer) == RoundingCount{12, 1, 3, 0});
  answer[0].attributes[0] = std::nextafter(TestType(0), TestType(1));
  CHECK(count(answer) == RoundingCount{12, 1, 3, 1});
}

TEST_CASE("rounding: a double is held to the nearest double, not to the nearest float") {
  Answer<double> answer = nearest_answer<double>();
  answer[0].position[0] = 1.0f / 3.0f;
  CHECK(count(answer).misrounded == 1);
}

TEST_CASE("rounding: other vertices have all numbers wrong") {
  Answer<float> answer = nearest_answer<float>();
  answer.pop_back();
  CHECK(count(answer) == RoundingCount{12, 12, 3, 3});
  CHECK(count(Answer<float>{}) == RoundingCount{12, 12, 3, 3});
}

TEST_CASE("rounding: vertices that fall together when they are rounded count as one") {
  reference::InputTriangle triangle;
  triangle.attribute_count = 1;
  triangle.vertices[0].position = {0, 0, 0, 1};
  triangle.vertices[1].position = {0.5, 0, 0, 1};
  triangle.vertices[2].position = {0.5, 0x1p-400, 0, 1};
  const TruthPolygon truth =
      truth_polygon(reference::Truth::of_clip(DepthRange::minus_one_to_one), triangle);
  REQUIRE(truth.exact.vertices.size() == 3);
  const Answer<float> answer = {{{0, 0, 0, 1}, {{0}}}, {{0.5f, 0, 0, 1}, {{0}}}};
  CHECK(count(answer, truth) == RoundingCount{12, 0, 3, 0});
}

TEST_CASE("rounding: what is visible in neither has no numbers, what is extra has wrong ones") {
  reference::InputTriangle triangle;
  triangle.attribute_count = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    triangle.vertices[i].position = {5.0 + static_cast<double>(i), 0, 0, 1};
  }
  const TruthPolygon outside =
      truth_polygon(reference::Truth::of_clip(DepthRange::minus_one_to_one), triangle);
  CHECK(count(Answer<float>{}, outside) == RoundingCount{});
  CHECK(count(nearest_answer<float>(), outside) == RoundingCount{12, 12, 3, 3});
}

TEST_CASE("rounding count: vertices are matched at the rotation that makes most numbers equal") {
  using Vertices = std::vector<std::array<float, 2>>;
  const Vertices wanted = {{0, 0}, {0x1p-140f, 0}, {0, 0x1p-140f}};
  const Vertices turned = {wanted[1], wanted[2], wanted[0]};
  CHECK(most_equal_rotation(wanted, turned) == 2);
  CHECK(equal_numbers(wanted, turned, 2) == 6);
  CHECK(equal_numbers(wanted, turned, 0) == 2);
}

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The integer clipper by hand: answers that a pencil finds.
#include <cmath>
#include <limits>

#include "tests/catch.hpp"
#include "tests/spaces/attack/integer_clip.hpp"
#include "tests/spaces/attack/judge.hpp"

namespace clipscope::attack {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

float nearest_to(long numerator, long denominator, int power = 0) {
  Quotient q{Integer(numerator), Integer(denominator)};
  if (power < 0) {
    q.denominator <<= static_cast<unsigned>(-power);
  } else {
    q.numerator <<= static_cast<unsigned>(power);
  }
  return nearest(q).value;
}

bool is_plus_zero(float x) { return x == 0 && !std::signbit(x); }
bool is_minus_zero(float x) { return x == 0 && std::signbit(x); }

Answer answer(const Batch& batch) {
  Facts unused;
  return exact_answer(batch, 0, unused);
}

bool is_polygon(const std::vector<float>& computed, const std::vector<float>& expected,
                std::size_t stride = 4) {
  return is_same_polygon(computed, expected, stride);
}

Batch in_clip_space(std::vector<float> floats, Volume volume = {}, int attributes = 0) {
  return {volume, {}, attributes, std::move(floats)};
}

}  // namespace

TEST_CASE("attack: a quotient of integers becomes the nearest float") {
  CHECK(nearest_to(1, 3) == 0x1.555556p-2f);
  CHECK(nearest_to(-2, 3) == -0x1.555556p-1f);
  CHECK(nearest_to(7, 7) == 1);
  CHECK(is_plus_zero(nearest_to(0, 5)));
  CHECK(nearest_to(0xFFFFFF, 1) == 0x1.fffffep+23f);
}

TEST_CASE("attack: half way between two floats an integer quotient goes to the even one") {
  CHECK(nearest_to((1 << 24) + 1, 1) == 0x1p24f);
  CHECK(nearest_to((1 << 24) + 3, 1) == 0x1.000004p24f);
  CHECK(nearest_to(-(1 << 24) - 3, 1) == -0x1.000004p24f);
  CHECK(nearest({Integer((1 << 24) + 1), Integer(1)}).is_tie);
  CHECK(!nearest({Integer((1 << 25) + 3), Integer(2)}).is_tie);
  CHECK(nearest({Integer((1 << 24) + 3), Integer(1)}).went_up);
}

TEST_CASE("attack: an integer quotient meets both ends of the range") {
  CHECK(nearest_to(1, 1, -149) == 0x1p-149f);
  CHECK(is_plus_zero(nearest_to(1, 2, -149)));  // a tie, and 0 is even
  CHECK(is_minus_zero(nearest_to(-1, 2, -149)));
  CHECK(nearest_to(3, 2, -149) == 0x1p-148f);
  CHECK(nearest_to(5, 8, -149) == 0x1p-149f);
  CHECK(is_minus_zero(nearest_to(-1, 1, -2000)));
  CHECK(nearest_to(0x1FFFFFF - 1, 2, 104) == std::numeric_limits<float>::max());
  CHECK(nearest_to(0x1FFFFFF, 2, 104) == kInfinity);  // half a unit above the largest: a tie
  CHECK(nearest_to(-1, 1, 3000) == -kInfinity);
}

TEST_CASE("attack: a float is an integer times 2^-149") {
  CHECK(scaled(0x1p-149f) == 1);
  CHECK(scaled(-0x1.8p-148f) == -3);
  CHECK(scaled(1) == Integer(1) << 149);
  CHECK(scaled(-0.0f) == 0);
  CHECK(scaled(0x1p-126f) == Integer(1) << 23);
  CHECK(scaled(std::numeric_limits<float>::max()) == Integer(0xFFFFFF) << 253);
}

TEST_CASE("attack: exact integers cut an edge in its middle") {
  // x = w at the middle of 0-1 and of 1-2.
  const Batch batch = in_clip_space({0, 0, 0, 1, 2, 0, 0, 1, 0, 0.5f, 0, 1});
  const Answer r = answer(batch);
  const std::vector<float> expected = {0, 0, 0, 1, 1, 0, 0, 1, 1, 0.25f, 0, 1, 0, 0.5f, 0, 1};
  CHECK(is_polygon(r.ndc, expected));
  CHECK(is_polygon(r.stage, expected));
}

TEST_CASE("attack: exact integers keep the bits of a vertex in the stage alone") {
  const Batch batch = in_clip_space({-0.0f, 0, -0.0f, 2, 4, 0, 0, 2, 0, 1, 0, 2});
  const Answer r = answer(batch);
  CHECK(is_polygon(r.stage, {-0.0f, 0, -0.0f, 2, 2, 0, 0, 2, 2, 0.5f, 0, 2, 0, 1, 0, 2}));
  CHECK(is_polygon(r.ndc, {0, 0, 0, 0.5f, 1, 0, 0, 0.5f, 1, 0.25f, 0, 0.5f, 0, 0.5f, 0, 0.5f}));
}

TEST_CASE("attack: exact integers find the corner of the volume inside a triangle") {
  // The triangle covers the quarter x, y >= 0 of the volume: only its corner (1, 1) is on two
  // planes.
  const Batch batch = in_clip_space({0, 0, 0, 1, 4, 0, 0, 1, 0, 4, 0, 1});
  CHECK(is_polygon(answer(batch).ndc, {0, 0, 0, 1, 1, 0, 0, 1, 1, 1, 0, 1, 0, 1, 0, 1}));
  Facts facts;
  exact_answer(batch, 0, facts);
  CHECK(facts[Fact::two_planes] == 1);
}

TEST_CASE("attack: exact integers leave out the vertex at the eye") {
  const Batch at_eye = in_clip_space({0, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 1});
  CHECK(answer(at_eye).ndc.empty());  // two corners are left
  const Batch behind = in_clip_space({0, 0, 0, -1, 1, 0, 0, -1, 0, 1, 0, -1});
  CHECK(answer(behind).ndc.empty());
}

TEST_CASE("attack: exact integers answer nothing in a side that owns no points") {
  Batch batch = in_clip_space({1, 0, 0, 1, 1, 1, 0, 1, 1, 0, 0.5f, 1});
  CHECK(answer(batch).ndc.size() == 12);
  batch.volume.is_open[1] = true;
  CHECK(answer(batch).ndc.empty());
}

TEST_CASE("attack: exact integers drop a clamped depth that rounds to infinity") {
  Batch batch = in_clip_space({0, 0, 1, 0x1p-149f, 1, 0, 0, 1, 0, 1, 0, 1});
  batch.volume.clamps_far = true;
  CHECK(answer(batch).ndc.empty());
  CHECK(answer(batch).stage.size() == 12);
}

TEST_CASE("attack: exact integers cut by a clip distance, which is +0 there") {
  const Batch batch =
      in_clip_space({0, 0, 0, 1, 1, 1, 0, 0, 1, -1, 0, 1, 0, 1, 1}, {.clip_distances = 1}, 1);
  CHECK(is_polygon(answer(batch).ndc,
                   {0, 0, 0, 1, 1, 0.5f, 0, 0, 1, 0, 0.5f, 0.5f, 0, 1, 0, 0, 1, 0, 1, 1}, 5));
}

TEST_CASE("attack: exact integers see through a frustum") {
  // In clip space (1, 1, -20/9, 0), (0, 0, 2/9, 2) and (1, 0, 2/9, 2); the near plane cuts two
  // edges in their middle.
  const Batch batch = {{}, Frustum{}, 0, {1, 1, 0, 0, 0, -2, 1, 0, -2}};
  const float ninth = nearest_to(1, 9);
  CHECK(is_polygon(answer(batch).ndc,
                   {0.5f, 0.5f, -1, 1, 0, 0, ninth, 0.5f, 0.5f, 0, ninth, 0.5f, 1, 0.5f, -1, 1}));
}

}  // namespace clipscope::attack

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The examples of experiments/plugins/: each is right about what it can do, and has its bug.
#include <algorithm>
#include <string>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "experiments/guests/plugin.hpp"
#include "experiments/guests/program.hpp"
#include "experiments/judge/compare.hpp"
#include "experiments/judge/questions.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

const Contestant& contestant_called(std::string_view name) {
  return *std::ranges::find(all_contestants(), name, &Contestant::clipper);
}

const Contestant& plugin_in(const std::string& library) {
  return contestant_called(add_plugin(library, 10));
}

// A triangle in clip space: of each vertex x y z w and an attribute.
using Numbers = std::vector<double>;
const Numbers kInside = {0, 0, 0, 1, 7, .5, 0, 0, 1, 8, 0, .5, .5, 1, 9};
const Numbers kAcrossRight = {0, 0, 0, 1, 0, 8, 0, 0, 2, 1, 0, .5, 0, 1, 0};
const Numbers kBehind = {0, 0, 0, 1, 0, .5, 0, 0, 1, 0, 0, -.5, -.5, -1, 0};
// All six planes cut it, and nine vertices are left.
const Numbers kNineVertices = {4, 0, 6, 2, 0, -4, -3, -1, 2, 0, 1, 4, -4, 3, 0};

Batch one_triangle(const Numbers& numbers) {
  Batch batch{.space = Space::clip, .attributes = 1};
  batch.numbers = std::span<const double>(numbers);
  return batch;
}

Comparison judged(const Contestant& contestant, const Numbers& numbers) {
  const Batch batch = one_triangle(numbers);
  const TruthPolygon truth = truth_polygons(reference::truth_of(batch), batch)[0];
  return compare(clip(contestant, batch)[0], truth);
}

bool breaks(const Contestant& contestant, const Numbers& numbers, Question question) {
  return examine(contestant, one_triangle(numbers), Questions::all())[0].violation(question);
}

TEST_CASE("examples: in C, a triangle with a vertex behind the eye is mirrored") {
  const Contestant& contestant = plugin_in(CLIPSCOPE_DIVIDE_FIRST);
  CHECK(judged(contestant, kInside).outcome == Outcome::exact);
  CHECK(judged(contestant, kAcrossRight).outcome <= Outcome::subpixel);
  CHECK(is_failure(judged(contestant, kBehind).outcome));
  // In clip space it is all of the triangle: nothing is lost, and too much is drawn.
  CHECK(breaks(contestant, kBehind, Question::contained));
  CHECK(breaks(contestant, kBehind, Question::winding));
  CHECK_FALSE(breaks(contestant, kAcrossRight, Question::contained));
}

TEST_CASE("examples: in C++, positions are right and attributes are not") {
  const Contestant& contestant = plugin_in(CLIPSCOPE_AFFINE_ATTRIBUTES);
  CHECK(judged(contestant, kInside).outcome == Outcome::exact);
  const Comparison comparison = judged(contestant, kAcrossRight);
  CHECK(comparison.outcome <= Outcome::subpixel);
  CHECK(comparison.attribute == Approx(1 / 4. - 1 / 7.).epsilon(1e-5));
  CHECK(judged(contestant, kBehind).outcome <= Outcome::subpixel);
}

#ifdef CLIPSCOPE_EIGHT_VERTICES
TEST_CASE("examples: in Rust, the ninth vertex is a crash, and of that triangle alone") {
  const Contestant& contestant = plugin_in(CLIPSCOPE_EIGHT_VERTICES);
  CHECK(judged(contestant, kInside).outcome == Outcome::exact);
  CHECK(judged(contestant, kNineVertices).outcome == Outcome::crashed);
  Numbers both = kNineVertices;
  both.insert(both.end(), kInside.begin(), kInside.end());
  const Answers answers = clip(contestant, one_triangle(both));
  CHECK(answers[0].failure() != nullptr);
  CHECK(answers[1].size() == 3);
}
#endif

TEST_CASE("examples: in Python, a new vertex lies a little off its plane") {
  const Contestant& contestant = contestant_called(add_program(
      {.command = "python3 '" CLIPSCOPE_SOURCE_DIR "/experiments/plugins/python/epsilon.py'",
       .name = "epsilon",
       .most_attributes = 32}));
  CHECK(judged(contestant, kInside).outcome == Outcome::exact);
  CHECK(judged(contestant, kAcrossRight).outcome != Outcome::exact);
  CHECK(breaks(contestant, kAcrossRight, Question::watertight));
  CHECK(breaks(contestant, kAcrossRight, Question::scale));
}

}  // namespace
}  // namespace clipscope::experiments

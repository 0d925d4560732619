// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hunt/sketch.hpp"

#include "experiments/hunt/breeding.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/survey/verdicts.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::hunt;

namespace {

const Contestant& chain(const char* scalar) {
  return find_contestant("homogeneous/sutherland_hodgman", scalar);
}

// A polygon of x y z 1/w.
Answers polygon_of(const std::vector<std::array<double, 4>>& vertices) {
  Answers answers(kFormat<float>, 4);
  for (const auto& v : vertices) {
    for (const double x : v) answers.add(static_cast<float>(x));
  }
  answers.end_polygon();
  return answers;
}

}  // namespace

TEST_CASE("sketch: repeated vertices count once, also from the last to the first") {
  const Answers answers = polygon_of(
      {{0, 0, 0, 1}, {0, 0, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}, {1, 1, 0, 2}, {0, 0, 0, 3}});
  const Sketch sketch(answers[0]);
  REQUIRE(sketch.size() == 3);
  CHECK(sketch[1][0] == 1);
  CHECK(sketch[2][1] == 1);
  CHECK(sketch.is_finite());
}

TEST_CASE("sketch: errors are those of the vertices that belong together") {
  const Answers wide = polygon_of({{0, 0, 0, 1}, {0.5, 0, 0, 1}, {0, 0.5, 0, 1}});
  const Answers turned = polygon_of({{0.5, 0, 0, 1}, {0, 0.5, 0, 1}, {0x1p-10, 0, 0, 1}});
  const Comparison c = sketched_errors(turned[0], Sketch(turned[0]), Sketch(wide[0])).comparison;
  CHECK(c.outcome == Outcome::exact);
  CHECK(c.position_px == 1920 * 0x1p-10);
}

TEST_CASE("sketch: what is missing, extra or has other vertices seems so") {
  const Answers triangle = polygon_of({{0, 0, 0, 1}, {0.5, 0, 0, 1}, {0, 0.5, 0, 1}}),
                square = polygon_of({{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}, {0, 1, 0, 1}}),
                nothing = polygon_of({});
  const auto seeming = [](const Answers& answer, const Answers& wide) {
    return sketched_errors(answer[0], Sketch(answer[0]), Sketch(wide[0])).comparison.outcome;
  };
  CHECK(seeming(triangle, square) == Outcome::vertex_count);
  CHECK(seeming(nothing, square) == Outcome::missing);
  CHECK(seeming(square, nothing) == Outcome::extra);
  CHECK(seeming(nothing, nothing) == Outcome::exact);
}

TEST_CASE("sketch: it agrees with the exact comparison but for the width of the wider scalar") {
  Random random(11);
  const Setting setting;
  int compared = 0;
  for (int i = 0; i < 400; ++i) {
    const HardCase c = case_of(setting, random_prey(setting, random), Prey::kAttributes);
    const Answers answer = clip_case(chain("float"), c), wide = clip_case(chain("double"), c);
    const Errors exact = errors_of(c, answer[0], truth_polygon(c));
    if (!exact.comparison.visible || exact.comparison.outcome > Outcome::visible) continue;
    const Errors cheap = sketched_errors(answer[0], Sketch(answer[0]), Sketch(wide[0]));
    if (cheap.comparison.outcome != Outcome::exact) continue;
    ++compared;
    CHECK(cheap.comparison.position_px ==
          Approx(exact.comparison.position_px).epsilon(1e-3).margin(1e-6));
    CHECK(cheap.depth_ulp == Approx(exact.depth_ulp).epsilon(1e-3).margin(1e-6));
  }
  CHECK(compared > 50);
}

TEST_CASE("sketch: a crack is the distance of what two sides have for the same point") {
  // The edge from (0, 0) to (1, 0); the attributes are barycentric coordinates.
  const auto side = [](double x, double third_y) {
    Answers answers(kFormat<double>, 8);
    const double numbers[3][8] = {
        {0, 0, 0, 1, 1, 0, 0, 1}, {x, 0, 0, 1, 0, 1, 0, 1}, {0, third_y, 0, 1, 0, 0, 1, 1}};
    for (const auto& vertex : numbers) {
      for (const double number : vertex) answers.add(number);
    }
    answers.end_polygon();
    return answers;
  };
  const Answers above = side(1 + 0x1p-10, 1), below = side(1, -1), wide_above = side(1, 1),
                wide_below = side(1, -1);
  const Sketch a(above[0]), b(below[0]), wide_a(wide_above[0]), wide_b(wide_below[0]);
  CHECK(crack_between({a, wide_a}, {b, wide_b}, 2) == 1920 * 0x1p-10);
  CHECK(crack_between({b, wide_b}, {b, wide_b}, 2) == 0);
  const Answers nothing = polygon_of({});
  const Sketch none(nothing[0]);
  CHECK(crack_between({none, wide_a}, {b, wide_b}, 2) == 0);
}

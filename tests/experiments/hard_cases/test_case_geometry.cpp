// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hard_cases/case_geometry.hpp"

#include <algorithm>

#include "experiments/catalogue/catalogue.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments::hard_cases {
namespace {

using reference::Rational;

ExactPosition position(Rational x, Rational y, Rational z = 0, Rational w = 1) {
  return {std::move(x), std::move(y), std::move(z), std::move(w)};
}

TEST_CASE("case geometry: the exact result lies in each space where it was found by hand") {
  const HardCase& c = find_case(builtin_catalogue(), "w_sign/eye_point_view");
  const CaseGeometry g = case_geometry(c, exact_polygon(c), {});
  // The near plane z = -1 cuts at (1/2, 1/2, -1), where w is 1 and z_clip -1.
  const Rational half(0.5);
  CHECK(std::ranges::count(g.visible_view, position(half, half, -1)) == 1);
  CHECK(std::ranges::count(g.visible_clip, position(half, half, -1, 1)) == 1);
  CHECK(std::ranges::count(g.visible_ndc, position(half, half, -1, 1)) == 1);
  CHECK(g.behind == std::vector<bool>{true, false, false});
  CHECK(g.places == std::vector<std::string>{"outside right top near", "inside", "inside"});
}

TEST_CASE("case geometry: an oblique projection is undone exactly") {
  const HardCase& c = find_case(builtin_catalogue(), "frustum_conventions/oblique");
  const CaseGeometry g = case_geometry(c, exact_polygon(c), {});
  CHECK(std::ranges::count(g.visible_view, g.input_view[0]) == 1);
}

TEST_CASE("case geometry: the largest error is the farthest from a nearest vertex, in px") {
  CaseGeometry g;
  g.visible_ndc = {position(0, 0), position(1, 0), position(1, 1)};
  g.answer_ndc = g.visible_ndc;
  CHECK(!largest_screen_error(g));
  g.answer_ndc[2] = position(1, 0.75);
  g.answer_ndc.push_back(position(0, Rational(1) / 64));
  const auto error = largest_screen_error(g);
  REQUIRE(error);
  CHECK(error->px == 270);
  CHECK(error->exact == g.visible_ndc[2]);
  g.answer_ndc.clear();
  CHECK(!largest_screen_error(g));
}

TEST_CASE("case geometry: vertices that are not finite are counted, an infinite 1/w is left out") {
  const HardCase& c = find_case(builtin_catalogue(), "w_sign/two_behind");
  const double infinity = HUGE_VAL;
  const CaseGeometry g = case_geometry(
      c, exact_polygon(c), {{0.5, 0, 0, infinity}, {infinity, 0, 0, 1}, {0, NAN, 0, 1}});
  CHECK(g.answer_ndc == ExactShape{position(Rational(0.5), 0, 0, 0)});
  CHECK(g.answer_not_finite == 2);
}

}  // namespace
}  // namespace clipscope::experiments::hard_cases

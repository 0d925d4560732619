// SPDX-License-Identifier: GPL-3.0-or-later
//
// Would ten small cases notice a bug? See mutants.hpp; the catalogue of hard cases is asked the
// same in tests/experiments/hard_cases/test_rows.cpp.
#include <cmath>
#include <random>
#include <string>

#include "reference/mutants.hpp"
#include "tests/catch.hpp"
#include "tests/reference/helpers.hpp"

namespace clipscope::reference {
namespace {

struct Case {
  std::string name;
  InputTriangle triangle;
};

// A triangle that reaches beyond one plane only.
InputTriangle beyond(int axis, double sign) {
  Position a = {0, 0, 0, 2}, b = {.5, 0, 0, 1}, c = {0, .5, .5, 1};
  a[axis] = 3 * sign;
  return triangle(a, b, c);
}

const Case kCases[] = {
    {"beyond left", beyond(0, -1)},
    {"beyond right", beyond(0, 1)},
    {"beyond bottom", beyond(1, -1)},
    {"beyond top", beyond(1, 1)},
    {"beyond near", beyond(2, -1)},
    {"beyond far", beyond(2, 1)},
    {"w from 3 to -3", triangle({-2, 0, 0, 3}, {4, 0, 0, -3}, {-2, .5, 0, 3})},
    {"mirrored at the eye", triangle({0, 0, 0, -1}, {-1, 0, 0, -2}, {0, -1, 0, -2})},
    {"scaled by 2^-40",
     triangle({0, 0, 0, 0x1p-40}, {0x1.8p-39, 0, 0, 0x1p-40}, {0, 0x1p-42, 0, 0x1p-40})},
    {"affine, w = 1", triangle({-2, 0, 0, 1}, {.5, 0, 0, 1}, {0, .5, 0, 1})},
};

struct Detection {
  Bug bug;
  std::vector<std::string> cases;  // all of kCases that tell the bug from none
};

const std::vector<std::string> kEveryCut = {"beyond left",    "beyond right",    "beyond bottom",
                                            "beyond top",     "beyond near",     "beyond far",
                                            "w from 3 to -3", "scaled by 2^-40", "affine, w = 1"};
const std::vector<std::string> kEveryPerspectiveCut = {
    "beyond left", "beyond right", "beyond bottom", "beyond top",
    "beyond near", "beyond far",   "w from 3 to -3"};

const Detection kTable[] = {
    {Bug::none, {}},
    {Bug::epsilon_in_denominator, kEveryCut},
    {Bug::absolute_w, {"w from 3 to -3", "mirrored at the eye"}},
    {Bug::w_sign_ignored, {"mirrored at the eye"}},
    {Bug::far_end_weighted, kEveryCut},
    {Bug::attributes_in_ndc, kEveryPerspectiveCut},
    {Bug::skips_left, {"beyond left", "affine, w = 1"}},
    {Bug::skips_right, {"beyond right", "w from 3 to -3", "scaled by 2^-40"}},
    {Bug::skips_bottom, {"beyond bottom"}},
    {Bug::skips_top, {"beyond top"}},
    {Bug::skips_near, {"beyond near"}},
    {Bug::skips_far, {"beyond far"}},
};

TEST_CASE("mutants: each bug is caught by the cases that the table names") {
  const Truth truth = Truth::of_clip(DepthRange::minus_one_to_one);
  for (const Detection& row : kTable) {
    std::vector<std::string> caught_by;
    for (const Case& c : kCases) {
      if (catches(row.bug, truth, c.triangle.vertices, c.triangle.attribute_count)) {
        caught_by.push_back(c.name);
      }
    }
    CAPTURE(static_cast<int>(row.bug));
    CHECK(caught_by == row.cases);
  }
}

TEST_CASE("mutants: the textbook clipper without a bug equals the reference") {
  Frustum<double> frustum = unit_frustum();
  frustum.left = -0.3;
  frustum.near = 0.1;
  const Truth truth =
      GENERATE_COPY(Truth::of_clip(DepthRange::minus_one_to_one), Truth::of_frustum(frustum),
                    Truth::of_clip(ClipVolume{.open_sides = true}),
                    Truth::of_matrix(Projection<float>(frustum_cast<float>(frustum))));
  std::mt19937 random(2);
  std::uniform_real_distribution<float> coordinate(-5, 5);
  std::uniform_int_distribution<int> exponent(-60, 60);
  for (int i = 0; i < 3000; ++i) {
    std::array<Position, 3> p;
    for (Position& q : p) {
      const double scale = i % 2 == 0 ? 1 : std::ldexp(1.0, exponent(random));
      for (double& c : q) c = coordinate(random) * scale;
    }
    const InputTriangle t = triangle(p[0], p[1], p[2]);
    CAPTURE(p);
    REQUIRE(textbook(Bug::none, truth, t) == vertex_set(clip(truth, t)));
  }
}

// In a side: its owner keeps it, a side that is open does not.
TEST_CASE("mutants: who takes open sides for closed ones, or the opposite ones, is caught") {
  const Truth truth = Truth::of_clip(ClipVolume{.open_sides = true});
  const InputTriangle right = triangle({1, 0, 0, 1}, {1, .5, 0, 1}, {2, 0, 1, 2});
  const InputTriangle left = triangle({-1, 0, 0, 1}, {-1, .5, 0, 1}, {-2, 0, 1, 2});
  CHECK(catches(Bug::closed_sides, truth, right.vertices, 3));
  CHECK_FALSE(catches(Bug::closed_sides, truth, left.vertices, 3));
  CHECK(catches(Bug::opposite_sides_open, truth, right.vertices, 3));
  CHECK(catches(Bug::opposite_sides_open, truth, left.vertices, 3));
}

// Coordinates of -1, 0 and 1 and their doubles: vertices, edges and whole triangles in the sides.
TEST_CASE("mutants: the textbook clipper equals the reference on triangles that touch open sides") {
  const Truth truth = Truth::of_clip(
      ClipVolume{.open_sides = GENERATE(OpenSides(true), OpenSides(true, true, true, true))});
  std::mt19937 random(7);
  std::uniform_int_distribution<int> coordinate(-1, 1), scale(0, 2);
  int owned = 0;
  for (int i = 0; i < 2000; ++i) {
    std::array<Position, 3> p;
    for (Position& q : p) {
      const int s = scale(random);
      q = {s * coordinate(random) * 1.0, s * coordinate(random) * 1.0, 0, s * 1.0};
    }
    const InputTriangle t = triangle(p[0], p[1], p[2]);
    CAPTURE(p);
    REQUIRE(textbook(Bug::none, truth, t) == vertex_set(clip(truth, t)));
    owned += clip(truth, t).vertices.empty() ? 0 : 1;
  }
  CHECK(owned > 200);
}

}  // namespace
}  // namespace clipscope::reference

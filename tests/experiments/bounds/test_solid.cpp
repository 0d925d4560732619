// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solids from words, their answers beside the exact ones, and their screen rectangles.
#include "experiments/bounds/solid.hpp"

#include <cmath>
#include <limits>

#include "experiments/bounds/rectangle.hpp"
#include "experiments/machine/errors.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::bounds;

namespace {

// 90 degrees both ways; near 1, far 10.
Region unit_region() { return region_of(Frustum<float>{}); }

Solid solid(std::string_view kind, std::vector<float> numbers) {
  return solid_of("input:1", kind, std::move(numbers));
}

AnswerRow answer(const Region& region, const Solid& s) {
  return answer_row(region, s.name, bounds_of(s).front(), exact_answer(region, s));
}

// Left, bottom, right, top; NaN where it is empty.
std::array<double, 4> members(const ScreenRectangle<double>& r) {
  return {r.left, r.bottom, r.right, r.top};
}

constexpr float kInfinity = std::numeric_limits<float>::infinity();

}  // namespace

TEST_CASE("solid: what is wrong with a line is named, with what is expected") {
  using Catch::Contains;
  CHECK_THROWS_WITH(
      solid("cube", {}),
      "input:1: 'cube' given; box, sphere, obb, points or polygon expected, and its numbers");
  CHECK_THROWS_WITH(solid("sphere", {1, 2, 3}),
                    "input:1: 3 numbers given; expected sphere X Y Z R");
  CHECK_THROWS_WITH(solid("points", {}), Contains("0 numbers given; expected points X Y Z ..."));
  CHECK_THROWS_WITH(solid("polygon", {1, 2, 3, 4}), Contains("4 numbers"));
  CHECK_THROWS_WITH(solid("box", {0, 0, 0, 1, -1, 1}), Contains("ends before it begins"));
  CHECK_THROWS_WITH(solid("sphere", {0, 0, 0, -1}), Contains("the radius is -1"));
}

TEST_CASE("solid: rejected, accepted and look closer, as exact arithmetic says") {
  const Region region = unit_region();
  const AnswerRow inside = answer(region, solid("sphere", {0, 0, -5, 1}));
  CHECK(inside.by_planes == "accepted");
  CHECK(inside.exact == "accepted");
  CHECK(inside.needless.empty());
  const AnswerRow behind = answer(region, solid("box", {0, 0, 1, 1, 1, 2}));
  CHECK(behind.by_planes == "rejected");
  CHECK(behind.exact == "rejected");
  const AnswerRow across = answer(region, solid("obb", {0, 0, -1, 1, 1, 0, -1, 1, 0, 0, 0, 1}));
  CHECK(across.by_axes == "look closer");
  CHECK(across.exact == "look closer");
  CHECK(across.needless.empty());
}

TEST_CASE("solid: a look closer is needless where all axes or exact arithmetic settle it") {
  const Region region = unit_region();
  // Beside the far right edge, outside of no plane.
  const AnswerRow beside = answer(region, solid("sphere", {13, 0, -14, 4.9f}));
  CHECK(beside.by_planes == "look closer");
  CHECK(beside.by_axes == "rejected");
  CHECK(beside.exact == "rejected");
  CHECK(beside.needless == "planes");
  // An ulp from touching: within rounding for every test.
  const AnswerRow touching =
      answer(region, solid("sphere", {13, 0, -14, std::nextafter(5.0f, 0.0f)}));
  CHECK(touching.exact == "rejected");
  CHECK(touching.needless == "planes, axes");
  CHECK(answer(region, solid("sphere", {13, 0, -14, 5})).exact == "look closer");
}

TEST_CASE("solid: points are bounded three ways, and the content has an answer of its own") {
  const Region region = unit_region();
  // A slanted segment whose box meets the frustum, though it does not.
  const Solid segment = solid("points", {2, 0, 1, 12, 0, -9});
  const Visibility content = exact_answer(region, segment);
  CHECK(content == Visibility::rejected);
  REQUIRE(bounds_of(segment).size() == 3);
  const AnswerRow box = answer_row(region, "s", bounds_of(segment)[0], content);
  CHECK(box.bound == "axis box");
  CHECK(box.exact == "look closer");
  CHECK(box.content == "rejected");
  const AnswerRow oriented = answer_row(region, "s", bounds_of(segment)[2], content);
  CHECK(oriented.by_planes == "rejected");
}

TEST_CASE("solid: triangles are accepted or rejected if all of them are") {
  const Region region = unit_region();
  const std::vector<Vec3<float>> inside = {{0, 0, -2}, {1, 0, -2}, {0, 1, -2}};
  const std::vector<Vec3<float>> behind = {{0, 0, 2}, {1, 0, 2}, {0, 1, 2}};
  std::vector<Vec3<float>> both = inside;
  both.insert(both.end(), behind.begin(), behind.end());
  const auto of = [&](const std::vector<Vec3<float>>& corners) {
    return exact_answer(region, std::span<const Vec3<float>>(corners));
  };
  CHECK(of(inside) == Visibility::accepted);
  CHECK(of(behind) == Visibility::rejected);
  CHECK(of(both) == Visibility::look_closer);
}

TEST_CASE("solid: a matrix as given and its frustum answer alike") {
  const Region frustum = unit_region();
  const Region matrix = region_of(DepthRange::minus_one_to_one, frustum.rows);
  REQUIRE(matrix.hull.known);
  for (const Solid& s :
       {solid("box", {10.5f, -5, -25, 30, 5, -5}), solid("sphere", {13, 0, -14, 4.9f}),
        solid("sphere", {0, 0, -5, 1}), solid("box", {-1, -1, -3, 1, 1, 0})}) {
    const AnswerRow a = answer(frustum, s), b = answer(matrix, s);
    CHECK(a.by_axes == b.by_axes);
    CHECK(a.exact == b.exact);
  }
  MatrixRows<float> singular = frustum.rows;
  singular[0] = singular[1];
  CHECK_FALSE(region_of(DepthRange::minus_one_to_one, singular).hull.known);
}

TEST_CASE("rectangle: a square before the eye, computed and exact") {
  const Region region = unit_region();
  const Solid square = solid("polygon", {-2, -2, -4, 2, -2, -4, 2, 2, -4, -2, 2, -4});
  for (const Part part : {Part::in_front, Part::beyond_near}) {
    const ExactRectangle exact = exact_rectangle(region, square, part);
    REQUIRE(exact);
    CHECK(members(*exact) == std::array{-0.5, -0.5, 0.5, 0.5});
    CHECK(rectangle_of(region, square, part) == ScreenRectangle<float>{-0.5f, -0.5f, 0.5f, 0.5f});
  }
}

TEST_CASE("rectangle: what reaches behind the eye has no end, but beyond near it has") {
  const Region region = unit_region();
  const Solid box = solid("box", {-1, 0, -4, 1, 0.5f, 4});
  const ExactRectangle front = exact_rectangle(region, box, Part::in_front);
  REQUIRE(front);
  CHECK(front->right == kInfinity);
  CHECK(front->left == -kInfinity);
  CHECK(front->bottom == 0);
  const ExactRectangle beyond = exact_rectangle(region, box, Part::beyond_near);
  REQUIRE(beyond);
  CHECK(beyond->left == Approx(-1));
  CHECK(beyond->top == Approx(0.5));
  CHECK(rectangle_of(region, box, Part::in_front).right == kInfinity);
  const ScreenRectangle<float> computed = rectangle_of(region, box, Part::beyond_near);
  CHECK(computed.right == Approx(1).epsilon(1e-6));
  CHECK(rectangle_of(region, box, Part::on_screen).right <= 1.0f);
  const Solid behind = solid("box", {-1, 0, 1, 1, 0.5f, 4});
  CHECK_FALSE(exact_rectangle(region, behind, Part::in_front));
  CHECK(rectangle_of(region, behind, Part::in_front).empty());
}

TEST_CASE("rectangle: rows in NDC and in px, exact ones beside all but spheres") {
  const Region region = unit_region();
  const Solid sphere = solid("sphere", {0, 0, 0, 2});  // at z = -1 a disc of radius sqrt 3
  const auto rows = rectangle_rows(region, sphere, std::array{640.0, 480.0});
  REQUIRE(rows.size() == 6);
  CHECK(rows[0].right == "inf");
  CHECK(std::stod(rows[2].right) == Approx(std::sqrt(3.0)));
  CHECK(rows[4].part == "on screen");
  CHECK(rows[4].right == "1");
  CHECK(rows[5].unit == "px");
  CHECK(rows[5].left == "0");
  CHECK(rows[5].bottom == "0");
  CHECK(rows[5].right == "640");
  CHECK(rows[5].top == "480");
  const Solid behind = solid("box", {-1, 0, 1, 1, 0.5f, 4});
  const auto empty = rectangle_rows(region, behind, {});
  REQUIRE(empty.size() == 5);
  CHECK(empty[1].part == "w > 0, exact");
  for (const RectangleRow& row : empty) CHECK(row.left == "-");
}

TEST_CASE("rectangle: y points down in px") {
  const Region region = unit_region();
  const Solid high = solid("polygon", {0, 2, -4, 2, 2, -4, 2, 4, -4});
  const auto rows = rectangle_rows(region, high, std::array{100.0, 100.0});
  CHECK(rows[0].bottom == "0.5");
  CHECK(rows[0].top == "1");
  CHECK(rows[1].bottom == "0");
  CHECK(rows[1].top == "25");
}

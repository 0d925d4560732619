// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hulls and spheres against half-spaces, by hand.
#include "reference/overlap.hpp"

#include <cmath>
#include <vector>

#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::reference;

namespace {

// 90 degrees both ways: at depth -z the sides are at +-z; near 1, far 10.
std::vector<LinearForm> unit_frustum() { return half_spaces_of(Truth::of_frustum({})); }

using Points = std::vector<ExactPoint>;

Points box(double x0, double x1, double y0, double y1, double z0, double z1) {
  Points r;
  for (const double x : {x0, x1}) {
    for (const double y : {y0, y1}) {
      for (const double z : {z0, z1}) r.push_back(exact_point(x, y, z));
    }
  }
  return r;
}

Overlap of(const Points& points) { return overlap(unit_frustum(), points); }
Overlap sphere(double x, double y, double z, double radius) {
  return overlap(unit_frustum(), exact_point(x, y, z), Dyadic(radius));
}

double above(double v) { return std::nextafter(v, HUGE_VAL); }
double below(double v) { return std::nextafter(v, -HUGE_VAL); }

}  // namespace

TEST_CASE("overlap: a box outside, inside and across the planes") {
  CHECK(of(box(-1, 1, -1, 1, -4, -2)) == Overlap::inside);
  CHECK(of(box(-1, 1, -1, 1, 1, 2)) == Overlap::outside);
  CHECK(of(box(-1, 1, -1, 1, -2, 0)) == Overlap::across);
  CHECK(of(box(-50, 50, -50, 50, -50, 50)) == Overlap::across);
}

TEST_CASE("overlap: what touches overlaps, and an ulp beside it does not") {
  CHECK(of(box(-1, 1, -1, 1, -1, 3)) == Overlap::across);
  CHECK(of(box(-1, 1, -1, 1, above(-1), 3)) == Overlap::outside);
  CHECK(of(box(10, 30, -5, 5, -25, -5)) == Overlap::across);  // the edge x = 10, z = -10
  CHECK(of(box(above(10), 30, -5, 5, -25, -5)) == Overlap::outside);
}

TEST_CASE("overlap: a box beside an edge is outside though it is outside of no plane") {
  // The far right edge is x = 10, z = -10; the box turned by 45 degrees about y has its own edge
  // there or beyond.
  const auto turned = [](double x) {
    Points r;
    for (const double y : {-5.0, 5.0}) {
      for (const double s : {-8.0, 8.0}) {
        r.push_back(exact_point(x, y, -10));
        r.push_back(exact_point(x + 8, y, -10 + s));
      }
    }
    return r;
  };
  CHECK(of(turned(10)) == Overlap::across);
  CHECK(of(turned(above(10))) == Overlap::outside);
}

TEST_CASE("overlap: hulls of one point, two and none") {
  CHECK(of({}) == Overlap::outside);
  CHECK(of({exact_point(0, 0, -5)}) == Overlap::inside);
  CHECK(of({exact_point(5, 0, -5)}) == Overlap::inside);
  CHECK(of({exact_point(above(5), 0, -5)}) == Overlap::outside);
  CHECK(of({exact_point(-30, 0, -5), exact_point(30, 0, -5)}) == Overlap::across);
  CHECK(of({exact_point(-30, 0, -5), exact_point(30, 0, 20)}) == Overlap::outside);
}

TEST_CASE("overlap: the same point many times, and points on a plane, end") {
  Points points(40, exact_point(10, 10, -10));
  points.push_back(exact_point(20, 0, -10));
  points.push_back(exact_point(0, 20, -10));
  CHECK(of(points) == Overlap::across);
}

TEST_CASE("overlap: a sphere by the nearest face, edge and corner") {
  CHECK(sphere(0, 0, -5, 3) == Overlap::inside);
  CHECK(sphere(0, 0, 1, 2) == Overlap::across);  // touches the near plane
  CHECK(sphere(0, 0, 1, below(2)) == Overlap::outside);
  CHECK(sphere(13, 0, -14, 5) == Overlap::across);  // 3, 4 from the edge x = 10, z = -10
  CHECK(sphere(13, 0, -14, below(5)) == Overlap::outside);
  CHECK(sphere(12, 11, -12, 3) == Overlap::across);  // 2, 1, 2 from the corner
  CHECK(sphere(12, 11, -12, below(3)) == Overlap::outside);
  CHECK(sphere(0, 0, -5, -1) == Overlap::outside);
  CHECK(sphere(0, 0, -5, 0) == Overlap::inside);
}

TEST_CASE("overlap: a sphere that touches a slanted plane from inside is inside") {
  // The right plane is -x - z >= 0 with the normal (-1, 0, -1) of length sqrt 2.
  const double distance = 5 / std::sqrt(2.0);  // rounded down
  CHECK(sphere(0, 0, -5, distance) == Overlap::inside);
  CHECK(sphere(0, 0, -5, above(distance)) == Overlap::across);
}

TEST_CASE("overlap: the planes of a matrix are those of its frustum") {
  // 2 n / (r - l) = 1; depth (-11 z - 20) / 9 for near 1, far 10, times 9.
  const MatrixRows<double> gl = {Vec4<double>(9, 0, 0, 0), Vec4<double>(0, 9, 0, 0),
                                 Vec4<double>(0, 0, -11, -20), Vec4<double>(0, 0, -9, 0)};
  const auto forms = half_spaces_of(Truth::of_matrix(gl, {}));
  REQUIRE(forms.size() == 6);
  CHECK(overlap(forms, box(10, 30, -5, 5, -25, -5)) == Overlap::across);
  CHECK(overlap(forms, box(above(10), 30, -5, 5, -25, -5)) == Overlap::outside);
  CHECK(overlap(forms, box(-1, 1, -1, 1, -1, 3)) == Overlap::across);
  CHECK(overlap(forms, box(-1, 1, -1, 1, above(-1), 3)) == Overlap::outside);
  // Reversed: depth (z + 10) / 9, near at w - z = 0.
  const MatrixRows<double> reversed = {Vec4<double>(9, 0, 0, 0), Vec4<double>(0, 9, 0, 0),
                                       Vec4<double>(0, 0, 1, 10), Vec4<double>(0, 0, -9, 0)};
  const auto back = half_spaces_of(Truth::of_matrix(reversed, {.depth = DepthRange::reversed}));
  CHECK(overlap(back, exact_point(0, 0, 1), Dyadic(2)) == Overlap::across);
  CHECK(overlap(back, exact_point(0, 0, 1), Dyadic(below(2))) == Overlap::outside);
  CHECK(sign(back[4], {{0, 0, -10, 1}, {}}) == 1);
}

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bounds of projected polygons and boxes, by hand; exact arithmetic has its say in
// tests/reference/test_projected_bounds_exact.cpp.
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "spaces/bounds/projected_bounds.hpp"
#include "tests/catch.hpp"

using namespace clipscope;

template <>
struct Catch::StringMaker<ScreenRectangle<float>> {
  static std::string convert(const ScreenRectangle<float>& r) {
    std::ostringstream out;
    out.precision(9);
    out << "x " << r.left << " to " << r.right << ", y " << r.bottom << " to " << r.top;
    return out.str();
  }
};

namespace {

using Polygon4 = std::vector<Vec4<float>>;
using Rectangle = ScreenRectangle<float>;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
const float kNan = std::nanf("");

float above(float v) { return std::nextafter(v, kInfinity); }
float below(float v) { return std::nextafter(v, -kInfinity); }

// Vertices (x, y, w).
Polygon4 polygon(std::initializer_list<std::array<float, 3>> vertices) {
  Polygon4 r;
  for (const auto& v : vertices) r.emplace_back(v[0], v[1], 0.0f, v[2]);
  return r;
}

Rectangle nearest(const Polygon4& p) { return projected_bounds<float>(p); }
Rectangle outward(const Polygon4& p) { return projected_bounds<float>(p, Rounding::outward); }
Rectangle nearest(const Rectangle& r, const Polygon4& p) {
  return projected_bounds_within<float>(r, p);
}
Rectangle outward(const Rectangle& r, const Polygon4& p) {
  return projected_bounds_within<float>(r, p, Rounding::outward);
}

// Both roundings must give this: nothing is to be rounded.
void check(const Polygon4& p, const Rectangle& expected) {
  CHECK(nearest(p) == expected);
  CHECK(outward(p) == expected);
}
void check(const Rectangle& within, const Polygon4& p, const Rectangle& expected) {
  CHECK(nearest(within, p) == expected);
  CHECK(outward(within, p) == expected);
}

constexpr Rectangle kUnit{-1, -1, 1, 1};

}  // namespace

TEST_CASE("projected bounds: a square in front of the eye") {
  const Polygon4 p = polygon({{-2, -2, 4}, {2, -2, 4}, {2, 2, 4}, {-2, 2, 4}});
  check(p, {-0.5f, -0.5f, 0.5f, 0.5f});
  check(kUnit, p, {-0.5f, -0.5f, 0.5f, 0.5f});
  check({0, 0, 2, 2}, p, {0, 0, 0.5f, 0.5f});
  check({-0.25f, -0.25f, 0.25f, 0.25f}, p, {-0.25f, -0.25f, 0.25f, 0.25f});
  CHECK(nearest({1, 1, 2, 2}, p).empty());
}

TEST_CASE("projected bounds: winding and first vertex make no difference") {
  const Polygon4 p = polygon({{3, 0, 1}, {0, 5, 2}, {-7, 1, -1}});
  const Rectangle expected = nearest(p), within = nearest(kUnit, p);
  for (const auto& order : {std::array{1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}}) {
    Polygon4 q;
    for (const int i : order) q.push_back(p[static_cast<std::size_t>(i)]);
    CHECK(nearest(q) == expected);
    CHECK(nearest(kUnit, q) == within);
  }
}

TEST_CASE("projected bounds: all behind the eye is empty, and a matrix's sign matters") {
  const Polygon4 p = polygon({{-2, -2, -4}, {2, -2, -4}, {2, 2, -4}});
  CHECK(nearest(p).empty());
  CHECK(outward(p).empty());
  CHECK(outward(kUnit, p).empty());
  Polygon4 negated;
  for (const auto& v : p) negated.push_back(-v);
  check(negated, {-0.5f, -0.5f, 0.5f, 0.5f});
}

TEST_CASE("projected bounds: w = 0 everywhere, the origin, nothing at all") {
  CHECK(nearest(polygon({{1, 2, 0}, {3, 4, 0}, {5, 0, 0}})).empty());
  CHECK(nearest(polygon({{0, 0, 0}})).empty());
  CHECK(nearest({}).empty());
  CHECK(outward(kUnit, {}).empty());
  CHECK(outward(kUnit, polygon({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}})).empty());
  CHECK(Rectangle{}.empty());
  CHECK(nearest(Rectangle{}, polygon({{0, 0, 1}})).empty());
}

TEST_CASE("projected bounds: x/w stays where it is while x and w go to 0 together") {
  // Along x = w from (1, 0, 1) to the origin and on to (-1, 0, -1): x/w is 1 all the way.
  check(polygon({{1, 0, 1}, {0, 0, 0}}), {1, 0, 1, 0});
  check(polygon({{1, 0, 1}, {-1, 0, -1}}), {1, 0, 1, 0});
  // With y = 1 at the far end y/w goes to infinity, x/w doesn't.
  check(polygon({{1, 0, 1}, {-1, 1, -1}}), {1, 0, 1, kInfinity});
  check(kUnit, polygon({{1, 0, 1}, {-1, 1, -1}}), {1, 0, 1, 1});
  // One ulp aside it does, in the direction of the ulp.
  CHECK(nearest(polygon({{1, 0, 1}, {above(-1), 0, -1}})) == Rectangle{1, 0, kInfinity, 0});
  CHECK(nearest(polygon({{1, 0, 1}, {below(-1), 0, -1}})) == Rectangle{-kInfinity, 0, 1, 0});
  // (1 + e) (1 - e) is less than 1, by less than float can tell.
  const float e = 0x1p-23f;
  CHECK(nearest(polygon({{1 + e, 0, 1}, {-1, 0, e - 1}})) == Rectangle{-kInfinity, 0, 1 + e, 0});
  // 1/3 isn't a float: both quotients round, yet the decision is exact.
  CHECK(nearest(polygon({{1, 0, 3}, {-5, 0, -15}})) == Rectangle{1.0f / 3, 0, 1.0f / 3, 0});
  const Rectangle r = outward(polygon({{1, 0, 3}, {-5, 0, -15}}));
  CHECK(r == Rectangle{below(1.0f / 3), 0, 1.0f / 3, 0});  // 1/3 rounds up
}

TEST_CASE("projected bounds: a vertex at w = 0 sends its sides to infinity") {
  check(polygon({{0, 0, 1}, {1, 0, 0}, {0, 1, 1}}), {0, 0, kInfinity, 1});
  check(polygon({{0, 0, 1}, {-1, -1, 0}, {0, 1, 1}}), {-kInfinity, -kInfinity, 0, 1});
  check(kUnit, polygon({{0, 0, 1}, {1, 0, 0}, {0, 1, 1}}), {0, 0, 1, 1});
  // Minus zero is zero.
  check(polygon({{0, 0, 1}, {1, 0, -0.0f}, {0, 1, 1}}), {0, 0, kInfinity, 1});
}

TEST_CASE("projected bounds: a Chromium quad with a small positive w") {
  const Polygon4 p =
      polygon({{-154, -109, 6e-8f}, {152, 44, 1.4f}, {152, 261, 1.4f}, {-154, 108, 6e-8f}});
  const Rectangle r = nearest(p);
  CHECK(r.left == -154 / 6e-8f);
  CHECK(r.bottom == -109 / 6e-8f);
  CHECK(r.right == 152 / 1.4f);
  CHECK(r.top == 108 / 6e-8f);
  // In a viewport the quad reaches its left side in full.
  const Rectangle within = outward({0, 0, 800, 600}, p);
  CHECK(within.left == 0.0f);
  CHECK(double{within.right} >= 152 / double{1.4f});
  CHECK(double{below(within.right)} < 152 / double{1.4f});
  CHECK(within.bottom == 0.0f);
  CHECK(std::abs(within.top - 262.5696f) < 1e-3f);  // where its upper edge has x = 0
}

TEST_CASE("projected bounds: Chromium quads with an edge to infinity") {
  check(polygon({{100, 10, 1}, {10, 10, 1}, {-10, -1, -1}, {-100, -1, -1}}),
        {10, 10, 100, kInfinity});
  check(polygon({{100, 10, 1}, {-110, -10, -1}, {-110, -100, -1}, {100, 100, 1}}),
        {-kInfinity, 10, 100, 100});
  check(Rectangle{0, 0, 50, 50},
        polygon({{100, 10, 1}, {10, 10, 1}, {-10, -1, -1}, {-100, -1, -1}}), {10, 10, 50, 50});
}

TEST_CASE("projected bounds: a Chromium quad along a diagonal with two vertices behind") {
  check(polygon({{-100, -100, 1}, {-10, -10, 1}, {10, 10, -1}, {100, 100, -1}}),
        {-100, -100, -10, -10});
  // With one vertex behind for real: from (10, 10) on towards (-10, 10, -1) the edge leaves by y.
  check(polygon({{-100, -100, 1}, {10, 10, 1}, {-10, 10, -1}}),
        {-kInfinity, -kInfinity, 10, kInfinity});
}

TEST_CASE("projected bounds: a square rotated by 89 degrees at perspective distance 50") {
  const float c = std::cos(1.5533430f), s = std::sin(1.5533430f);
  const auto at = [&](float x, float y) { return std::array{x, y * c, 1 - y * s / 50}; };
  // The left edge is x = 0 all along, so x/w is 0 until it vanishes.
  const Polygon4 right = polygon({at(0, 0), at(100, 0), at(100, 100), at(0, 100)});
  CHECK(nearest(right) == Rectangle{0, 0, kInfinity, kInfinity});
  CHECK(outward(right) == Rectangle{0, 0, kInfinity, kInfinity});
  CHECK(outward({-50, -50, 50, 50}, right) == Rectangle{0, 0, 50, 50});
  const Polygon4 left = polygon({at(-100, 0), at(0, 0), at(0, 100), at(-100, 100)});
  CHECK(nearest(left) == Rectangle{-kInfinity, 0, 0, kInfinity});
  CHECK(outward({-50, -50, 50, 50}, left) == Rectangle{-50, 0, 0, 50});
}

TEST_CASE("projected bounds: coordinates that overflowed may be anywhere") {
  const float huge = 1e37f * 1e37f;
  const Polygon4 p = polygon({{0, 0, 1}, {huge, 0, huge}, {0, huge, 1}});
  CHECK(nearest(p) == Rectangle::everything());
  CHECK(outward(kUnit, p) == kUnit);
  const Polygon4 q = polygon({{0, 0, 1}, {1, kNan, 1}, {0, 1, 1}});
  CHECK(nearest(q) == Rectangle::everything());
  CHECK(nearest(kUnit, q) == kUnit);
  // 1e37 itself is a number as any other.
  check(polygon({{0, 0, 1}, {1e37f, 0, 1e37f}, {0, 1e37f, 1e37f}}), {0, 0, 1, 1});
}

TEST_CASE("projected bounds: z is not looked at") {
  const Polygon4 p = {Vec4<float>(0, 0, kNan, 1), Vec4<float>(1, 1, kInfinity, 1)};
  check(p, {0, 0, 1, 1});
}

TEST_CASE("projected bounds: the homography of a Skia bug, every w small and positive") {
  glm::mat<3, 3, float, glm::defaultp> m;
  m[0] = Vec3<float>(1.52695269e-4f, -1.75697533e-5f, -6.00415362e-8f);
  m[1] = Vec3<float>(0, 1.57153074e-4f, 0);
  m[2] = Vec3<float>(-6.53848401e-5f, -1.10847975e-6f, 1.69880834e-4f);
  const auto p = corners(m, {0, 0, 319, 620});
  const Rectangle r = projected_bounds<float>(p);
  CHECK(r.left == p[0][0] / p[0][3]);
  CHECK(r.right == p[1][0] / p[1][3]);
  CHECK(r.bottom == p[1][1] / p[1][3]);
  CHECK(r.top == p[2][1] / p[2][3]);
  // Powers of two don't change the picture.
  for (const float scale : {0x1p-60f, 0x1p60f}) {
    Polygon4 q;
    for (const auto& v : p) q.push_back(scale * v);
    CHECK(nearest(q) == r);
    CHECK(outward({0, 0, 256, 256}, q) ==
          projected_bounds_within<float>({0, 0, 256, 256}, p, Rounding::outward));
  }
}

TEST_CASE("projected bounds: a large rectangle nearly along the screen, within a narrow one") {
  const Polygon4 p = polygon({{100, -2852, 1}, {1803, -2852, 1}, {1803, 1168, 1}, {100, 1168, 1}});
  check(p, {100, -2852, 1803, 1168});
  check({0, -430, 2048, 2048}, p, {100, -430, 1803, 1168});
  check({0, 0, 816, 1039}, p, {100, 0, 816, 1039});
}

TEST_CASE("projected bounds: mixed signs of w are no reason for a mirror image") {
  // max(|w|, eps) would put the third vertex at (1, 1), inside.
  const Polygon4 p = polygon({{4, 0, 2}, {8, 0, 2}, {1, 1, -1}});
  const Rectangle r = nearest(p);
  CHECK(r.left == 2.0f);
  CHECK(r.right == kInfinity);
  CHECK(r.bottom == 0.0f);
  CHECK(r.top == kInfinity);
  CHECK(outward(kUnit, p).empty());
}

TEST_CASE("projected bounds: a rectangle touched in a side or a corner is not missed") {
  const auto square = [](float x0, float y0, float x1, float y1) {
    return polygon({{x0, y0, 1}, {x1, y0, 1}, {x1, y1, 1}, {x0, y1, 1}});
  };
  check(kUnit, square(1, -2, 2, 2), {1, -1, 1, 1});
  check(kUnit, square(1, 1, 2, 2), {1, 1, 1, 1});
  CHECK(outward(kUnit, square(above(1), -2, 2, 2)).empty());
  CHECK(outward(kUnit, square(above(1), above(1), 2, 2)).empty());
  check(kUnit, square(below(1), -2, 2, 2), {below(1), -1, 1, 1});
  // An edge across a corner, x + y = 2, and one ulp beyond.
  check(kUnit, polygon({{0, 2, 1}, {2, 0, 1}, {4, 4, 1}}), {1, 1, 1, 1});
  CHECK(outward(kUnit, polygon({{0, above(2), 1}, {above(2), 0, 1}, {4, 4, 1}})).empty());
}

TEST_CASE("projected bounds: a polygon around the rectangle covers all of it") {
  check(kUnit, polygon({{-9, -9, 1}, {9, -9, 1}, {0, 9, 1}}), kUnit);
  // Also if it reaches behind the eye.
  check(kUnit, polygon({{-9, -9, 1}, {9, -9, 1}, {0, 18, -1}}), kUnit);
}

TEST_CASE("projected bounds: points and segments") {
  check(polygon({{3, 4, 2}}), {1.5f, 2, 1.5f, 2});
  check({0, 0, 2, 2}, polygon({{3, 4, 2}}), {1.5f, 2, 1.5f, 2});
  CHECK(outward(kUnit, polygon({{3, 4, 2}})).empty());
  check(kUnit, polygon({{-2, 0, 1}, {2, 1, 1}}), {-1, 0.25f, 1, 0.75f});
  check(kUnit, polygon({{-2, 0, 1}, {2, 0, 1}}), {-1, 0, 1, 0});
  // A rectangle without width.
  check(Rectangle{0, -1, 0, 1}, polygon({{-2, 0, 1}, {2, 1, 1}}), {0, 0.5f, 0, 0.5f});
}

TEST_CASE("projected bounds: outward contains what nearest may cut off") {
  const Polygon4 p = polygon({{1, 1, 3}, {2, 2, 3}, {1, 2, 3}});
  const Rectangle near = nearest(p), out = outward(p);
  CHECK(near == Rectangle{1.0f / 3, 1.0f / 3, 2.0f / 3, 2.0f / 3});
  CHECK(out == Rectangle{below(1.0f / 3), below(1.0f / 3), 2.0f / 3, 2.0f / 3});
  // Cut at y = 1/4 an edge has x = 1/12, which is no float.
  const Rectangle cut = outward({0, 0, 1, 0.25f}, polygon({{0, 0, 1}, {1, 3, 1}, {0, 3, 1}}));
  CHECK(double{cut.right} * 12 >= 1);
  CHECK(double{below(cut.right)} * 12 < 1);
}

TEST_CASE("projected bounds: a quotient that overflows is the largest number below it outward") {
  const Polygon4 p = polygon({{1e30f, -1e30f, 1e-30f}});
  CHECK(nearest(p) == Rectangle{kInfinity, -kInfinity, kInfinity, -kInfinity});
  const float most = std::numeric_limits<float>::max();
  CHECK(outward(p) == Rectangle{most, -kInfinity, kInfinity, -most});
}

TEST_CASE("projected bounds: a box in front, across and around the eye") {
  glm::mat<4, 4, float, glm::defaultp> m(0.0f);  // x, y, w = -z
  m[0][0] = m[1][1] = 1;
  m[2][3] = -1;
  const auto at = [&](float x0, float x1, float y0, float y1, float z0, float z1) {
    return corners(m, AxisBox<float>{Vec3<float>(x0, y0, z0), Vec3<float>(x1, y1, z1)});
  };
  CHECK(projected_bounds(at(-1, 1, 0, 1, -4, -2)) == Rectangle{-0.5f, 0, 0.5f, 0.5f});
  CHECK(projected_bounds(at(1, 2, 0, 1, -4, -2)) == Rectangle{0.25f, 0, 1, 0.5f});
  CHECK(projected_bounds(at(1, 2, 0, 1, -4, 4)) == Rectangle{0.25f, 0, kInfinity, kInfinity});
  CHECK(projected_bounds(at(-1, 1, -1, 1, -4, 4)) == Rectangle::everything());
  CHECK(projected_bounds(at(-1, 1, -1, 1, 2, 4)).empty());
  CHECK(projected_bounds_within(kUnit, at(-1, 1, 0, 1, -4, -2)) == Rectangle{-0.5f, 0, 0.5f, 0.5f});
  CHECK(projected_bounds_within(kUnit, at(1, 2, 0, 1, -4, 4)) == Rectangle{0.25f, 0, 1, 1});
  CHECK(projected_bounds_within(kUnit, at(-1, 1, -1, 1, -4, 4)) == kUnit);
  CHECK(projected_bounds_within(kUnit, at(8, 9, -1, 1, -4, -2), Rounding::outward).empty());
}

TEST_CASE("projected bounds: px of a viewport, y up and y down") {
  const Rectangle ndc{-1, -0.5f, 0.5f, 1};
  CHECK(to_px(Rectangle{0, 0, 640, 480}, ndc) == Rectangle{0, 120, 480, 480});
  CHECK(to_px(Rectangle{0, 480, 640, 0}, ndc) == Rectangle{0, 0, 480, 360});
  CHECK(to_px(Rectangle{10, 20, 650, 500}, ndc, Rounding::outward) == Rectangle{10, 140, 490, 500});
  CHECK(to_px(Rectangle{0, 480, 640, 0}, Rectangle{-kInfinity, 0, 2, kInfinity}) ==
        Rectangle{-kInfinity, -kInfinity, 960, 240});
  CHECK(to_px(Rectangle{0, 0, 640, 480}, Rectangle{}).empty());
  const Rectangle third{-1.0f / 3, 0, 1.0f / 3, 0};
  const Rectangle px = to_px(Rectangle{0, 0, 641, 480}, third, Rounding::outward);
  CHECK(double{px.left} <= (1 + double{third.left}) * 320.5);
  CHECK(double{px.right} >= (1 + double{third.right}) * 320.5);
  CHECK(double{above(px.left)} > (1 + double{third.left}) * 320.5);
}

TEST_CASE("enclosure: products are compared exactly") {
  const double e = 0x1p-52;
  CHECK(compare_products(1 + e, 1 - e, 1.0, 1.0) == -1);  // 1 - e^2
  CHECK(compare_products(1.0, 1.0, 1 + e, 1 - e) == 1);
  CHECK(compare_products(1 + e, 1 + e, 1 + 2 * e, 1.0) == 1);
  CHECK(compare_products(-(1 + e), 1 + e, 1 + 2 * e, -1.0) == -1);
  CHECK(compare_products(3.0, 5.0, 15.0, 1.0) == 0);
  CHECK(compare_products(-3.0, 5.0, 3.0, 5.0) == -1);
  CHECK(compare_products(0.0, 5.0, -0.0, 1e300) == 0);
  CHECK(compare_products(0.0, 5.0, 1e-300, 1e-300) == -1);
  // The products under- and overflow; their order doesn't.
  CHECK(compare_products(1e-300, 1e-300, 1e-300, std::nextafter(1e-300, 1.0)) == -1);
  CHECK(compare_products(1e300, 1e300, 1e300, std::nextafter(1e300, 1e308)) == -1);
  CHECK(compare_products(0x1p-1074, 0x1p-1074, 0x1p-1074, 0x1p-1073) == -1);
  CHECK(compare_products(0x1p-1074, 0x1p1000, 0x1p-537, 0x1p463) == 0);
  CHECK(compare_products(1 + 0x1p-23f, 1 - 0x1p-23f, 1.0f, 1.0f) == -1);
  CHECK(compare_products(0x1p-149f, 0x1p-149f, 0x1p-149f, 0x1p-148f) == -1);
}

TEST_CASE("enclosure: exact results stay points, others get one ulp") {
  const auto is = [](const Enclosure<double>& e, double low, double high) {
    CHECK(e.low == low);
    CHECK(e.high == high);
  };
  const double e = 0x1p-52, infinity = std::numeric_limits<double>::infinity();
  const double most = std::numeric_limits<double>::max(), least = 0x1p-1074;
  is(bounds::sum(1.0, 2.0), 3, 3);
  is(bounds::sum(1.0, 0x1p-60), 1, 1 + e);
  is(bounds::sum(1.0, -0x1p-60), 1 - e / 2, 1);
  is(bounds::product(3.0, 5.0), 15, 15);
  is(bounds::product(1 + e, 1 + e), 1 + 2 * e, 1 + 3 * e);
  is(bounds::product(0x1p-600, 0x1p-600), -least, least);
  is(bounds::product(1e200, 1e200), most, infinity);
  is(bounds::product(0.0, -5.0), 0, 0);
  is(bounds::quotient(6.0, 3.0), 2, 2);
  is(bounds::quotient(1.0, 3.0), 1.0 / 3, std::nextafter(1.0 / 3, 1.0));
  is(bounds::quotient(-1.0, 3.0), -std::nextafter(1.0 / 3, 1.0), -1.0 / 3);
  is(bounds::quotient(1e300, 1e-300), most, infinity);
  is(Enclosure<double>(-2, 4) / Enclosure<double>(1, 2), -2, 4);
  is(Enclosure<double>(2, 4) / Enclosure<double>(1, 2), 1, 4);
  is(scaled(Enclosure<double>(1, 2), -3.0), -6, -3);
}

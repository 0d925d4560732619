// SPDX-License-Identifier: GPL-3.0-or-later
//
// The 2D algorithms on their own: segments and polygons of the plane against a rectangle.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "spaces/window/cyrus_beck.hpp"
#include "spaces/window/kodituwakku_wijeweera_chamikara.hpp"
#include "spaces/window/matthes_drakopoulos.hpp"
#include "spaces/window/midpoint_subdivision.hpp"
#include "spaces/window/ray.hpp"
#include "spaces/window/skala.hpp"
#include "spaces/window/sobkow_pospisil_yang.hpp"
#include "spaces/window/sutherland_hodgman.hpp"
#include "tests/catch.hpp"
#include "tests/spaces/segments.hpp"

using namespace clipscope;
using namespace clipscope::tests;
using experiments::Exact;
using experiments::scalar_from;

namespace {

template <class T>
using Answer = std::optional<Segment2<T>>;

// The answers of the algorithms that compute an intersection and bound its error.
template <class T>
std::vector<Answer<T>> computed_answers(const Rectangle<T>& r, const Segment2<T>& s) {
  return {window::cohen_sutherland(r, s),           window::liang_barsky(r, s),
          window::liang_barsky_division_free(r, s), window::nicholl_lee_nicholl(r, s),
          window::sobkow_pospisil_yang(r, s),       window::ray(r, s),
          window::matthes_drakopoulos(r, s),        window::cyrus_beck(r, s)};
}

// The answers of all algorithms whose error is bounded in rounded arithmetic.
template <class T>
std::vector<Answer<T>> bounded_answers(const Rectangle<T>& r, const Segment2<T>& s) {
  std::vector<Answer<T>> answers = computed_answers(r, s);
  if constexpr (kHasInfinity<T>) answers.push_back(window::midpoint_subdivision(r, s));
  return answers;
}

// The answers of all algorithms.
template <class T>
std::vector<Answer<T>> all_answers(const Rectangle<T>& r, const Segment2<T>& s) {
  std::vector<Answer<T>> answers = bounded_answers(r, s);
  answers.push_back(window::kodituwakku_wijeweera_chamikara(r, s));
  answers.push_back(window::skala(r, s));
  return answers;
}

template <class T>
Segment2<T> segment_2d(double x0, double y0, double x1, double y1) {
  return {Vec2<T>(scalar_from<T>(x0), scalar_from<T>(y0)),
          Vec2<T>(scalar_from<T>(x1), scalar_from<T>(y1))};
}

template <class T>
bool same_answer(const Answer<T>& a, const Answer<T>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return is_same_position((*a)[0], (*b)[0]) && is_same_position((*a)[1], (*b)[1]);
}

// A screen in pixels, and segments of a lattice around it: ends in all nine regions, on sides and
// corners.
const Rectangle<Exact> kScreen = {Exact(0), Exact(4), Exact(1), Exact(3)};

Answer<Exact> exact_answer(const Rectangle<Exact>& r, const Segment2<Exact>& s) {
  const auto part = visible_interval<Exact>(kSidePlanes, Exact(0), [&](Plane side) {
    return std::array<Exact, 2>{side_distance(r, side, s[0]), side_distance(r, side, s[1])};
  });
  if (!part || is_same_position(s[0], s[1])) return std::nullopt;
  Segment2<Exact> answer;
  for (int i = 0; i < 2; ++i) {
    answer[0][i] = s[0][i] + part->from * (s[1][i] - s[0][i]);
    answer[1][i] = s[0][i] + part->to * (s[1][i] - s[0][i]);
  }
  return answer;
}

}  // namespace

TEST_CASE("window: on a whole lattice every algorithm has the exact segment") {
  int visible = 0;
  for (int i = 0; i < 8 * 7 * 8 * 7; ++i) {
    const auto s = segment_2d<Exact>(i % 8 - 2, i / 8 % 7 - 1, i / 56 % 8 - 2, i / 448 - 1);
    const Answer<Exact> expected = exact_answer(kScreen, s);
    visible += expected ? 1 : 0;
    int algorithm = 0;
    for (const Answer<Exact>& found : all_answers(kScreen, s)) {
      INFO("segment " << i << ", algorithm " << algorithm++);
      CHECK(same_answer(found, expected));
    }
  }
  CHECK(visible > 1000);
}

TEST_CASE("window: every algorithm has the exact segment of random ones in a random rectangle") {
  std::mt19937_64 random(55);
  int visible = 0;
  for (int n = 0; n < 2000; ++n) {
    const Ends corners = random_ends(random, 2);
    const auto [left, right] = std::minmax(corners[0][0], corners[1][0]);
    const auto [bottom, top] = std::minmax(corners[0][1], corners[1][1]);
    const Rectangle<Exact> r = {Exact(left), Exact(right), Exact(bottom), Exact(top)};
    const Ends e = random_ends(random, std::ldexp(1.0, n % 4));
    const auto s = segment_2d<Exact>(e[0][0], e[0][1], e[1][0], e[1][1]);
    const Answer<Exact> expected = exact_answer(r, s);
    visible += expected ? 1 : 0;
    for (const Answer<Exact>& found : all_answers(r, s)) CHECK(same_answer(found, expected));
    for (const Answer<Exact>& found : all_answers(r, reversed(s))) {
      CHECK(same_answer(found, expected ? Answer<Exact>(reversed(*expected)) : expected));
    }
  }
  CHECK(visible > 100);
}

// An error of 32 u M in the plane explains less than 64 u M along a side that is met at 45 degrees.
TEST_CASE("window: in float the bounded algorithms agree where no corner is near") {
  std::mt19937_64 random(56);
  const Rectangle<float> r;
  for (int n = 0; n < 20000; ++n) {
    const Ends e = random_ends(random, 1);
    // From left to right at 45 degrees at most, through the middle of the window.
    const auto s =
        segment_2d<float>(-2 - std::abs(e[0][0]), e[0][1] / 4, 2 + std::abs(e[1][0]), e[1][1] / 4);
    const Answer<float> expected = window::liang_barsky_division_free(r, s);
    REQUIRE(expected);
    for (const Answer<float>& found : bounded_answers(r, s)) {
      REQUIRE(found);
      for (std::size_t i = 0; i < 2; ++i) {
        CHECK((*found)[i][0] == (*expected)[i][0]);
        CHECK(std::abs((*found)[i][1] - (*expected)[i][1]) < 64 * 0x1p-24f * 3);
      }
    }
  }
}

TEST_CASE("window: bisection stops at the neighbours of a side, however far the end") {
  const Rectangle<float> r;
  for (const float far : {std::nextafter(1.0f, 2.0f), 1.5f, 1e10f, 1e38f}) {
    const auto found = window::midpoint_subdivision(r, segment_2d<float>(0, 0.25, far, 0.25));
    REQUIRE(found);
    CHECK((*found)[1][0] == 1);
    CHECK((*found)[1][1] == 0.25f);
  }
  CHECK_FALSE(window::midpoint_subdivision(r, segment_2d<float>(-3, 0, 0, 3)));
  static_assert(!std::invocable<MidpointSubdivision, RectangleSpace<Exact>, Segment2<Exact>>);
}

TEST_CASE("window: lines in a side are kept in both directions, and narrow ones, too") {
  const Rectangle<Exact> r = kScreen;
  for (const auto& s :
       {segment_2d<Exact>(-1, 3, 5, 3), segment_2d<Exact>(-1, 1, 2, 1),
        segment_2d<Exact>(4, 0, 4, 9), segment_2d<Exact>(0, 2, 0, 3),
        segment_2d<Exact>(1, 0, 1.25, 9), segment_2d<Exact>(1.5, 1.5, 1.625, 1.75)}) {
    for (const Segment2<Exact>& way : {s, reversed(s)}) {
      REQUIRE(exact_answer(r, way));
      for (const Answer<Exact>& found : all_answers(r, way)) {
        CHECK(same_answer(found, exact_answer(r, way)));
      }
    }
  }
}

// Why these two promise no bound.
TEST_CASE("window: of a short segment slope and intercept, and line and corners, lose the place") {
  const Rectangle<float> r;
  const auto s = segment_2d<float>(0.9999f, 0.9999f, 0.99991f, 1.00001f);
  for (const Answer<float>& found : bounded_answers(r, s)) {
    REQUIRE(found);
    CHECK(std::abs((*found)[1][0] - 0.9999091f) < 1e-6f);
    CHECK((*found)[1][1] == 1);
  }
  const auto by_slope = window::kodituwakku_wijeweera_chamikara(r, s);
  CHECK((!by_slope || std::abs((*by_slope)[1][0] - 0.9999091f) > 5e-5f));
  const auto by_line = window::skala(r, s);
  CHECK((!by_line || (*by_line)[1][1] == -1));
}

TEST_CASE("window: Nicholl-Lee-Nicholl and division-free Liang-Barsky give the same bits") {
  std::mt19937_64 random(51);
  const Rectangle<float> r;
  for (int n = 0; n < 20000; ++n) {
    const Ends e = random_ends(random, 4);
    const auto s = segment_2d<float>(e[0][0], e[0][1], e[1][0], e[1][1]);
    CHECK(same_answer(window::nicholl_lee_nicholl(r, s), window::liang_barsky_division_free(r, s)));
  }
}

TEST_CASE("window: a new end has the coordinate of its side exactly") {
  std::mt19937_64 random(52);
  const Rectangle<float> r{.left = -0.1f, .right = 0.7f, .bottom = 0.3f, .top = 0.9f};
  for (int n = 0; n < 5000; ++n) {
    const Ends e = random_ends(random, 2);
    const auto s = segment_2d<float>(e[0][0], e[0][1], e[1][0], e[1][1]);
    for (const Answer<float>& found : all_answers(r, s)) {
      if (!found) continue;
      for (std::size_t i = 0; i < 2; ++i) {
        const Vec2<float>& p = (*found)[i];
        const bool on_side = p[0] == r.left || p[0] == r.right || p[1] == r.bottom || p[1] == r.top;
        CHECK((on_side || is_same_position(p, s[i])));
      }
    }
  }
}

TEST_CASE("window: ulp neighbours of a corner pass inside, through it and outside") {
  const float above = std::nextafter(1.0f, 2.0f), below = std::nextafter(1.0f, 0.0f);
  const Rectangle<float> r;
  const auto visible = [&](float x, float y) {
    // Down to the right at 45 degrees, through (x, y) near the corner (1, 1).
    const auto s = segment_2d<float>(x - 0.5f, y + 0.5f, x + 0.5f, y - 0.5f);
    const auto answers = computed_answers(r, s);
    const auto has_value = [](const Answer<float>& a) { return a.has_value(); };
    const auto found = std::ranges::count_if(answers, has_value);
    CHECK((found == 0 || found == std::ssize(answers)));
    return found > 0;
  };
  CHECK(visible(below, below));
  CHECK_FALSE(visible(1, 1));
  CHECK_FALSE(visible(above, above));
}

TEST_CASE("window: NaN and infinity yield nothing, and nothing not finite comes out") {
  using Limits = std::numeric_limits<float>;
  const Rectangle<float> r;
  for (const float bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()}) {
    for (int coordinate = 0; coordinate < 4; ++coordinate) {
      for (const float far : {0.5f, 3.0f, Limits::infinity()}) {
        std::array<float, 4> c = {0, 0.25f, far, 0.5f};
        c[static_cast<std::size_t>(coordinate)] = bad;
        for (const auto& found : all_answers(r, segment_2d<float>(c[0], c[1], c[2], c[3]))) {
          CHECK_FALSE(found.has_value());
        }
      }
    }
  }
  std::mt19937_64 random(53);
  const std::array<float, 8> specials = {
      0.0f, -0.0f, Limits::denorm_min(), Limits::min(), Limits::max(), -Limits::max(), 1.0f, -2.0f};
  for (int n = 0; n < 8 * 8 * 8 * 8; ++n) {
    const auto pick = [&](int i) { return specials[static_cast<std::size_t>(n >> (3 * i)) % 8]; };
    for (const auto& found :
         all_answers(r, segment_2d<float>(pick(0), pick(1), pick(2), pick(3)))) {
      if (!found) continue;
      for (const Vec2<float>& p : *found) CHECK((is_finite(p[0]) && is_finite(p[1])));
    }
  }
}

TEST_CASE("window: a polygon of the plane is cut by the four sides") {
  using Points = std::vector<Vec2<double>>;
  const Rectangle<double> r{.left = 0, .right = 2, .bottom = 0, .top = 2};
  Points scratch;
  Points diamond = {{1, -1}, {3, 1}, {1, 3}, {-1, 1}};
  window::cut_sides(r, diamond, scratch);
  REQUIRE(diamond.size() == 4);  // it cuts each corner of the square in that corner alone
  double area = 0;
  for (std::size_t i = 0; i < diamond.size(); ++i) {
    const auto &a = diamond[i], &b = diamond[(i + 1) % diamond.size()];
    area += (a[0] * b[1] - a[1] * b[0]) / 2;
  }
  CHECK(area == 4);
  Points outside = {{3, 0}, {4, 0}, {3, 1}};
  window::cut_sides(r, outside, scratch);
  CHECK(outside.empty());
  Points touching = {{2, 0}, {4, 0}, {4, 1}};
  window::cut_sides(r, touching, scratch);
  CHECK(touching.empty());
}

TEST_CASE(
    "window: sides cut after the divide, depth cut before, is the homogeneous polygon exactly") {
  std::mt19937_64 random(54);
  for (int n = 0; n < 300; ++n) {
    const auto triangle = clip_triangle<Exact>(random_corners(random, 3));
    ClipPolygon<Exact, K> polygon, scratch;
    polygon.assign(triangle);
    const ClipPolygon<Exact, K>& in_depth =
        cut_by_planes(polygon, scratch, bit(Plane::near) | bit(Plane::far), kAllPlanes,
                      [](Plane plane, const ClipVertex<Exact, K>& v) {
                        return signed_distance(DepthRange::minus_one_to_one, plane, v);
                      });
    NdcPolygon<Exact, K> found, expected;
    bool divisible = true;
    for (const auto& v : in_depth) {
      divisible = divisible && Exact(0) < v.position[3];
      if (divisible) found.push_back(to_ndc(v));
    }
    if (!divisible) continue;
    found.drop_if_degenerate();
    window::cut_sides(Rectangle<Exact>{}, found);
    HomogeneousSutherlandHodgman{}(ClipVolume{}, triangle, expected);
    CHECK(same_cycle(found, expected));
  }
}

TEST_CASE("window: on a polygon inside the rectangle nothing is computed") {
  using experiments::Counted;
  NdcPolygon<Counted, K> polygon;
  for (const auto& v : clip_triangle<Counted>({{{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}}})) {
    polygon.push_back(to_ndc(v));
  }
  operation_counts() = {};
  window::cut_sides(Rectangle<Counted>{}, polygon);
  CHECK(polygon.size() == 3);
  CHECK(operation_counts().additions + operation_counts().multiplications +
            operation_counts().divisions ==
        0);
}

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cases small enough to be checked by hand.
#include "reference/exact_clip.hpp"

#include "tests/catch.hpp"
#include "tests/reference/helpers.hpp"

namespace clipscope::reference {
namespace {

const Truth kClip = Truth::of_clip(DepthRange::minus_one_to_one);

// x, y, z, 1/w and the three barycentric coordinates.
RationalVertex vertex(Rational x, Rational y, Rational z, Rational inv_w, Rational l0, Rational l1,
                      Rational l2) {
  return {x, y, z, inv_w, {l0, l1, l2}};
}

std::vector<RationalVertex> sorted(std::vector<RationalVertex> vertices) {
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

TEST_CASE("reference: a triangle inside comes back as it is") {
  const ExactPolygon p = clip(kClip, triangle({0, 0, 0, 1}, {1, 0, 0, 2}, {0, 1, 0, 4}));
  CHECK(p.verdict == Verdict::accepted);
  REQUIRE(p.vertices.size() == 3);
  CHECK(vertex_set(p) ==
        sorted({vertex(0, 0, 0, 1, 1, 0, 0), vertex(ratio(1, 2), 0, 0, ratio(1, 2), 0, 1, 0),
                vertex(0, ratio(1, 4), 0, ratio(1, 4), 0, 0, 1)}));
}

TEST_CASE("reference: a triangle behind the eye yields nothing") {
  const Truth truth = Truth::of_frustum(unit_frustum());
  const ExactPolygon p = clip(truth, triangle({0, 0, 1, 1}, {1, 0, 2, 1}, {0, 1, 3, 1}));
  CHECK(p.verdict == Verdict::rejected);
  CHECK(p.vertices.empty());
}

TEST_CASE("reference: a triangle outside of no single plane can still miss the volume") {
  const InputTriangle t = triangle({3, 0, 0, 1}, {0, 3, 0, 1}, {3, 3, 0, 1});
  CHECK(classify(kClip, t) == Verdict::clipped);
  CHECK(clip(kClip, t).verdict == Verdict::rejected);
  CHECK(clip(kClip, t).vertices.empty());
}

// a-b: x = 2 t, w = 1 + t/2, w - x = 1 - 3 t/2: t = 2/3, x = w = 4/3.
// c-b: the same, and y = 1 - t = 1/3.
TEST_CASE("reference: one plane turns a triangle into a quadrilateral") {
  const ExactPolygon p = clip(kClip, triangle({0, 0, 0, 1}, {2, 0, 0, 1.5}, {0, 1, 0, 1}));
  CHECK(p.verdict == Verdict::clipped);
  CHECK(vertex_set(p) ==
        sorted({vertex(0, 0, 0, 1, 1, 0, 0), vertex(0, 1, 0, 1, 0, 0, 1),
                vertex(1, 0, 0, ratio(3, 4), ratio(1, 3), ratio(2, 3), 0),
                vertex(1, ratio(1, 4), 0, ratio(3, 4), 0, ratio(2, 3), ratio(1, 3))}));
}

// The edge from z = -1/2 to z = -2 meets the near plane z = -1 at t = 1/3.
TEST_CASE("reference: the near plane cuts in view space where z = -near") {
  const Truth truth = Truth::of_frustum(unit_frustum());
  const ExactPolygon p = clip(truth, triangle({0, 0, -0.5, 1}, {0, 0, -2, 1}, {0, 1, -2, 1}));
  CHECK(vertex_set(p) == sorted({vertex(0, 0, -1, 1, ratio(2, 3), ratio(1, 3), 0),
                                 vertex(0, ratio(1, 3), -1, 1, ratio(2, 3), 0, ratio(1, 3)),
                                 vertex(0, 0, ratio(1, 9), ratio(1, 2), 0, 1, 0),
                                 vertex(0, ratio(1, 2), ratio(1, 9), ratio(1, 2), 0, 0, 1)}));
}

TEST_CASE("reference: the winding is kept") {
  const ExactPolygon p = clip(kClip, triangle({0, 0, 0, 1}, {2, 0, 0, 1}, {0, 2, 0, 1}));
  REQUIRE(p.vertices.size() == 4);
  std::array<double, 3> x, y;
  for (int i = 0; i < 3; ++i) {
    x[i] = approximate(p.vertices[i].x);
    y[i] = approximate(p.vertices[i].y);
  }
  CHECK((x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]) == 1);
}

TEST_CASE("reference: a triangle that touches a corner yields one vertex") {
  const ExactPolygon p = clip(kClip, triangle({1, 1, 1, 1}, {2, 1, 1, 1}, {1, 2, 1, 1}));
  CHECK(p.verdict == Verdict::clipped);
  CHECK(vertex_set(p) == sorted({vertex(1, 1, 1, 1, 1, 0, 0)}));
}

TEST_CASE("reference: a triangle whose edge passes through a corner yields one vertex") {
  const ExactPolygon p = clip(kClip, triangle({2, 0, 1, 1}, {0, 2, 1, 1}, {2, 2, 1, 1}));
  CHECK(vertex_set(p) == sorted({vertex(1, 1, 1, 1, ratio(1, 2), ratio(1, 2), 0)}));
}

TEST_CASE("reference: a triangle that touches an edge yields two vertices") {
  const ExactPolygon p = clip(kClip, triangle({1, -2, 0, 1}, {1, 2, 0, 1}, {2, 0, 0, 1}));
  CHECK(vertex_set(p) == sorted({vertex(1, -1, 0, 1, ratio(3, 4), ratio(1, 4), 0),
                                 vertex(1, 1, 0, 1, ratio(1, 4), ratio(3, 4), 0)}));
}

TEST_CASE("reference: a triangle in a plane of the volume is inside") {
  const ExactPolygon p = clip(kClip, triangle({1, 0, 0, 1}, {1, 1, 0, 1}, {1, 0, 1, 1}));
  CHECK(p.verdict == Verdict::accepted);
  CHECK(p.vertices.size() == 3);
}

TEST_CASE("reference: a triangle that covers the volume yields its cross-section") {
  const ExactPolygon p = clip(kClip, triangle({-8, -8, 0, 1}, {8, -8, 0, 1}, {0, 16, 0, 1}));
  std::vector<std::array<Rational, 2>> corners;
  for (const ExactVertex& v : p.vertices) corners.push_back({to_rational(v.x), to_rational(v.y)});
  std::sort(corners.begin(), corners.end());
  CHECK(corners == std::vector<std::array<Rational, 2>>{{-1, -1}, {-1, 1}, {1, -1}, {1, 1}});
}

// The plane x + y + z = 0 meets the cube in a hexagon, whose six corners are cut in pairs by the
// triangle's edges.
TEST_CASE("reference: six planes leave nine vertices") {
  const double a = 1.75;
  const ExactPolygon p = clip(kClip, triangle({a, -a, 0, 1}, {0, a, -a, 1}, {-a, 0, a, 1}));
  CHECK(p.vertices.size() == 9);
}

TEST_CASE("reference: a vertex at the eye is cut off by the near plane") {
  const Truth truth = Truth::of_frustum(unit_frustum());
  const ExactPolygon p = clip(truth, triangle({0, 0, 0, 1}, {1, 0, -2, 1}, {0, 1, -2, 1}));
  CHECK(vertex_set(p) == sorted({vertex(ratio(1, 2), 0, -1, 1, ratio(1, 2), ratio(1, 2), 0),
                                 vertex(0, ratio(1, 2), -1, 1, ratio(1, 2), 0, ratio(1, 2)),
                                 vertex(ratio(1, 2), 0, ratio(1, 9), ratio(1, 2), 0, 1, 0),
                                 vertex(0, ratio(1, 2), ratio(1, 9), ratio(1, 2), 0, 0, 1)}));
}

TEST_CASE("reference: the clip position (0, 0, 0, 0) is outside") {
  const InputTriangle t = triangle({0, 0, 0, 0}, {1, 0, 0, 2}, {0, 1, 0, 2});
  CHECK(classify(kClip, t) == Verdict::clipped);
  CHECK(vertex_set(clip(kClip, t)) == sorted({vertex(ratio(1, 2), 0, 0, ratio(1, 2), 0, 1, 0),
                                              vertex(0, ratio(1, 2), 0, ratio(1, 2), 0, 0, 1)}));
  CHECK(clip(kClip, triangle({0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0})).vertices.empty());
}

// x = -2 + 6 t, w = 3 - 6 t: w + x = 1 everywhere, w - x = 5 - 12 t.
TEST_CASE("reference: the segment from (-2, 3) to (4, -3) is cut only at x = w") {
  const ExactPolygon p = clip(kClip, triangle({-2, 0, 0, 3}, {4, 0, 0, -3}, {-2, .5, 0, 3}));
  REQUIRE(p.vertices.size() == 4);
  CHECK(vertex_set(p).back() == vertex(1, ratio(7, 12), 0, 2, 0, ratio(5, 12), ratio(7, 12)));
}

TEST_CASE("reference: homogeneous points with w < 0 only are outside") {
  CHECK(clip(kClip, triangle({0, 0, 0, -1}, {-1, 0, 0, -2}, {0, -1, 0, -2})).vertices.empty());
}

TEST_CASE("reference: scaling by a power of two changes nothing but 1/w") {
  const int k = GENERATE(-900, -44, -1, 1, 36, 900);
  const double s = std::ldexp(1.0, k);
  const Position a = {-.5, -.5, .125, 1}, b = {.5, -.5, .125, 1}, c = {0, .25, -1.375, -1};
  const auto scaled = [s](const Position& p) {
    return Position{p[0] * s, p[1] * s, p[2] * s, p[3] * s};
  };
  std::vector<RationalVertex> expected = vertex_set(clip(kClip, triangle(a, b, c)));
  REQUIRE(expected.size() >= 3);
  for (RationalVertex& v : expected) v.inv_w /= to_rational(s);
  CHECK(vertex_set(clip(kClip, triangle(scaled(a), scaled(b), scaled(c)))) == sorted(expected));
}

TEST_CASE(
    "reference: a vertex that is no corner of the triangle has a coordinate of exactly -1 or 1") {
  const ExactPolygon p =
      clip(kClip, triangle({-3.7, 0.1, 0.2, 1.3}, {4.1, -0.3, 0.1, 0.7}, {0.3, 5.3, -0.2, 2.1}));
  REQUIRE(p.vertices.size() == 4);
  for (const ExactVertex& v : p.vertices) {
    const auto is_one = [](const Fraction& f) {
      return f == Fraction{1, 1} || f == Fraction{-1, 1};
    };
    CHECK((is_one(v.x) || is_one(v.y) || is_one(v.z)));
  }
}

TEST_CASE("reference: a triangle that is a point or a segment stays one") {
  const Position a = {0, 0, 0, 1}, b = {2, 0, 0, 1};
  CHECK(clip(kClip, triangle(a, a, a)).vertices.size() == 1);
  CHECK(clip(kClip, triangle(b, b, b)).vertices.empty());
  CHECK(vertex_set(clip(kClip, triangle(a, b, a))).size() == 2);
}

// a and b are the same point in NDC, at different w.
TEST_CASE("reference: a plane through the eye is a segment in NDC") {
  const ExactPolygon p = clip(kClip, triangle({0, 0, 0, 1}, {0, 0, 0, 2}, {.5, 0, 0, 1}));
  CHECK(p.verdict == Verdict::accepted);
  CHECK(p.vertices.size() == 2);
}

TEST_CASE("reference: without a far plane the horizon is reached, not crossed") {
  Frustum<double> frustum = unit_frustum();
  frustum.infinite_far = true;
  const InputTriangle t = triangle({0, 0, -2, 1}, {1, 0, -1e30, 1}, {0, 1, -1e30, 1});
  CHECK(clip(Truth::of_frustum(frustum), t).verdict == Verdict::accepted);
  CHECK(clip(Truth::of_frustum(unit_frustum()), t).verdict == Verdict::clipped);
}

TEST_CASE("reference: an inset volume lies within, an outset one around") {
  const InputTriangle t = triangle({-8, -8, 0, 1}, {8, -8, 0, 1}, {0, 16, 0, 1});
  for (const ExactVertex& v : clip(kClip.inset(0.25), t).vertices) {
    CHECK((v.x == Fraction{3, 4} || v.x == Fraction{-3, 4}));
  }
  for (const ExactVertex& v : clip(kClip.inset(-0.25), t).vertices) {
    CHECK((v.x == Fraction{5, 4} || v.x == Fraction{-5, 4}));
  }
}

}  // namespace
}  // namespace clipscope::reference

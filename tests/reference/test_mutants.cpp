// SPDX-License-Identifier: GPL-3.0-or-later
//
// Would the reference's cases notice a bug? A textbook clipper over rationals, in clip space, equals
// the reference as long as it has no bug; with each bug known from real clippers it must differ on
// the cases that the table below names.
#include <cmath>
#include <random>
#include <string>

#include "reference/exact_clip.hpp"
#include "tests/catch.hpp"
#include "tests/reference/helpers.hpp"

namespace clipscope::reference {
namespace {

enum class Bug {
  none,
  epsilon_in_denominator,  // t = d_a / (d_a - d_b + 1e-10)
  absolute_w,              // w replaced by |w|
  w_sign_ignored,          // |x / w| <= 1 without asking for w > 0
  far_end_weighted,        // t taken from the wrong end of the edge
  attributes_in_ndc,       // attributes interpolated after the divide
  skips_left,
  skips_right,
  skips_bottom,
  skips_top,
  skips_near,
  skips_far
};

// x, y, z, w, attributes.
using Vertex = std::vector<Rational>;

Vertex input_vertex(Bug bug, const Truth& truth, const InputTriangle& triangle, int i) {
  Vertex r;
  for (const Rational& c : truth.clip_position(triangle.vertices[i])) {
    r.push_back(c);
  }
  for (int k = 0; k < triangle.attribute_count; ++k) {
    r.push_back(to_rational(triangle.vertices[i].attributes[k]));
  }
  if (bug == Bug::absolute_w) {
    r[3] = abs(r[3]);
  }
  return r;
}

// Depth range [-1, 1]: left, right, bottom, top, near, far.
Rational distance(Bug bug, const Vertex& v, int plane) {
  const Rational c = plane % 2 == 0 ? Rational(v[plane / 2]) : Rational(-v[plane / 2]);
  const Rational d = v[3] + c;
  return bug == Bug::w_sign_ignored && v[3] < 0 ? Rational(-d) : d;
}

Vertex meet(Bug bug, const Vertex& a, const Rational& d_a, const Vertex& b, const Rational& d_b) {
  const Rational epsilon = bug == Bug::epsilon_in_denominator ? to_rational(1e-10) : Rational(0);
  Rational t = d_a / (d_a - d_b + epsilon);
  if (bug == Bug::far_end_weighted) {
    t = 1 - t;
  }
  Rational t_attributes = t;
  const Rational w = (1 - t) * a[3] + t * b[3];
  if (bug == Bug::attributes_in_ndc && w != 0) {
    t_attributes = t * b[3] / w;
  }
  Vertex r;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Rational& s = i < 4 ? t : t_attributes;
    r.push_back((1 - s) * a[i] + s * b[i]);
  }
  return r;
}

std::vector<Vertex> cut(Bug bug, const std::vector<Vertex>& polygon, int plane) {
  std::vector<Vertex> r;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vertex& a = polygon[i];
    const Vertex& b = polygon[(i + 1) % polygon.size()];
    const Rational d_a = distance(bug, a, plane), d_b = distance(bug, b, plane);
    if (d_a >= 0) {
      r.push_back(a);
    }
    if ((d_a > 0 && d_b < 0) || (d_a < 0 && d_b > 0)) {
      r.push_back(meet(bug, a, d_a, b, d_b));
    }
  }
  return r;
}

std::vector<RationalVertex> textbook(Bug bug, const Truth& truth, const InputTriangle& triangle) {
  std::vector<Vertex> polygon;
  for (int i = 0; i < 3; ++i) {
    polygon.push_back(input_vertex(bug, truth, triangle, i));
  }
  const int skipped = static_cast<int>(bug) - static_cast<int>(Bug::skips_left);
  for (int plane = 0; plane < 6; ++plane) {
    if (plane != skipped) {
      polygon = cut(bug, polygon, plane);
    }
  }
  std::vector<RationalVertex> r;
  for (const Vertex& v : polygon) {
    if (v[3] > 0 || (bug == Bug::w_sign_ignored && v[3] < 0)) {
      r.push_back({Rational(v[0] / v[3]), Rational(v[1] / v[3]), Rational(v[2] / v[3]),
                   Rational(1 / v[3]), Vertex(v.begin() + 4, v.end())});
    }
  }
  std::sort(r.begin(), r.end());
  r.erase(std::unique(r.begin(), r.end()), r.end());
  return r;
}

bool caught(Bug bug, const Truth& truth, const InputTriangle& triangle) {
  return textbook(bug, truth, triangle) != vertex_set(clip(truth, triangle));
}

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
      if (caught(row.bug, truth, c.triangle)) {
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
                    Truth::of_matrix(Projection<float>(frustum_cast<float>(frustum))));
  std::mt19937 random(2);
  std::uniform_real_distribution<float> coordinate(-5, 5);
  std::uniform_int_distribution<int> exponent(-60, 60);
  for (int i = 0; i < 3000; ++i) {
    std::array<Position, 3> p;
    for (Position& q : p) {
      const double scale = i % 2 == 0 ? 1 : std::ldexp(1.0, exponent(random));
      for (double& c : q) {
        c = coordinate(random) * scale;
      }
    }
    const InputTriangle t = triangle(p[0], p[1], p[2]);
    CAPTURE(p);
    REQUIRE(textbook(Bug::none, truth, t) == vertex_set(clip(truth, t)));
  }
}

}  // namespace
}  // namespace clipscope::reference

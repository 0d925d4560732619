// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/truth.hpp"

#include <limits>
#include <random>

#include "tests/catch.hpp"
#include "tests/reference/helpers.hpp"

namespace clipscope::reference {
namespace {

using Clip = std::array<Rational, 4>;

InputVertex at(double x, double y, double z) { return {{x, y, z, 1}, {}}; }

TEST_CASE("truth: the point (1, 1, 0) has the clip coordinates (1, 1, -20/9, 0)") {
  const Truth truth = Truth::of_frustum(unit_frustum());
  CHECK(truth.clip_position(at(1, 1, 0)) == Clip{1, 1, ratio(-20, 9), 0});
}

TEST_CASE("truth: a matrix of sixteen numbers is taken as given, with each of its six planes") {
  // The rows of x + 2 y + 3 z + 4 and so on; no frustum has such a matrix.
  const MatrixRows<double> rows = {Vec4<double>(1, 2, 3, 4), Vec4<double>(0, 1, 0, -1),
                                   Vec4<double>(0, 0, 1, 0), Vec4<double>(1, 0, 0, 8)};
  const Truth truth = Truth::of_matrix(rows, {.depth = DepthRange::zero_to_one});
  CHECK(truth.kind() == TruthKind::matrix);
  CHECK(truth.clip_position(at(1, 1, 1)) == Clip{10, 0, 1, 9});
  REQUIRE(truth.half_spaces().size() == 6);
  const int expected[] = {19, -1, 9, 9, 1, 8};  // w + x, w - x, w + y, w - y, z, w - z
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(value(truth.half_spaces()[i].form, at(1, 1, 1)) == Dyadic(expected[i]));
  }
  MatrixRows<double> broken = rows;
  broken[2][1] = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(Truth::of_matrix(broken, {}), std::invalid_argument);
}

TEST_CASE("truth: further planes cut view space, and clip space with w") {
  const std::array<double, 4> plane = {1, 0, 0, -2};
  const Truth view = Truth::of_frustum(unit_frustum()).with_planes(std::span(&plane, 1));
  CHECK(value(view.half_spaces().back().form, at(5, 0, -1)) == Dyadic(3));
  const Truth clip = Truth::of_clip(ClipVolume{}).with_planes(std::span(&plane, 1));
  CHECK(value(clip.half_spaces().back().form, {{5, 0, 0, 3}, {}}) == Dyadic(-1));
}

TEST_CASE("truth: near and far planes go to the ends of the depth range") {
  struct Ends {
    DepthRange depth;
    int near, far;
  };
  const auto ends = GENERATE(Ends{DepthRange::minus_one_to_one, -1, 1},
                             Ends{DepthRange::zero_to_one, 0, 1}, Ends{DepthRange::reversed, 1, 0});
  const auto kind = GENERATE(ProjectionKind::perspective, ProjectionKind::parallel);
  Frustum<double> frustum = unit_frustum();
  frustum.kind = kind;
  frustum.depth = ends.depth;
  const Truth truth = Truth::of_frustum(frustum);

  const Clip near = truth.clip_position(at(0, 0, -1));
  const Clip far = truth.clip_position(at(0, 0, -10));

  CHECK(near[2] == ends.near * near[3]);
  CHECK(far[2] == ends.far * far[3]);
  CHECK(far[3] == (kind == ProjectionKind::perspective ? 10 : 1));
}

TEST_CASE("truth: with an infinite far plane depth tends to the end of its range") {
  struct Case {
    DepthRange depth;
    int near, at_ten;  // z_clip at distance 1 and at distance 10
  };
  const auto c = GENERATE(Case{DepthRange::minus_one_to_one, -1, 8},
                          Case{DepthRange::zero_to_one, 0, 9}, Case{DepthRange::reversed, 1, 1});
  Frustum<double> frustum = unit_frustum();
  frustum.infinite_far = true;
  frustum.depth = c.depth;
  const Truth truth = Truth::of_frustum(frustum);
  CHECK(truth.half_spaces().size() == 5);
  CHECK(truth.clip_position(at(0, 0, -1))[2] == c.near);
  CHECK(truth.clip_position(at(0, 0, -10))[2] == c.at_ten);
}

TEST_CASE("truth: the sides of an off-centre frustum go to -1 and 1") {
  Frustum<double> frustum = unit_frustum();
  frustum.left = -2;
  frustum.right = 4;
  frustum.bottom = 1;
  frustum.top = 3;
  const Truth truth = Truth::of_frustum(frustum);
  const Clip low = truth.clip_position(at(-4, 2, -2));
  const Clip high = truth.clip_position(at(8, 6, -2));
  CHECK(low[0] == -2);
  CHECK(low[1] == -2);
  CHECK(high[0] == 2);
  CHECK(high[1] == 2);
}

TEST_CASE("truth: an oblique parallel projection shears x and y by z") {
  Frustum<double> frustum = unit_frustum();
  frustum.kind = ProjectionKind::parallel;
  frustum.shear_x = 0.5;
  frustum.shear_y = -0.25;
  const Truth truth = Truth::of_frustum(frustum);
  const Clip clip = truth.clip_position(at(2, -1, -4));
  CHECK(clip[0] == 0);
  CHECK(clip[1] == 0);
}

// d_p = form * clip_scale is w + x and so on: 1/4 of it is what an inset by 1/4 takes away.
TEST_CASE("truth: an inset of 1/4 moves each plane by 1/4 in clip-space units") {
  const auto kind = GENERATE(ProjectionKind::perspective, ProjectionKind::parallel);
  const auto depth =
      GENERATE(DepthRange::minus_one_to_one, DepthRange::zero_to_one, DepthRange::reversed);
  Frustum<double> frustum = unit_frustum();  // near 2, far 10: all factors are exact
  frustum.kind = kind;
  frustum.depth = depth;
  frustum.near = 2;
  frustum.far = 4;
  const Truth truth = Truth::of_frustum(frustum);
  const Truth inset = truth.inset(0.25);
  const InputVertex v = at(0.5, 0.25, -3);
  const Clip clip = truth.clip_position(v);
  const Rational x = clip[0], y = clip[1], z = clip[2], w = clip[3];
  const Rational low = depth == DepthRange::minus_one_to_one ? Rational(w + z) : Rational(z);
  const Rational high = w - z;
  const bool reversed = depth == DepthRange::reversed;
  const std::vector<Rational> d = {Rational(w + x), Rational(w - x),       Rational(w + y),
                                   Rational(w - y), reversed ? high : low, reversed ? low : high};
  REQUIRE(inset.half_spaces().size() == d.size());
  for (std::size_t p = 0; p < d.size(); ++p) {
    CAPTURE(p);
    const Truth::HalfSpace& plane = inset.half_spaces()[p];
    const Rational form = to_rational(value(plane.form, v)) * to_rational(plane.clip_scale);
    CHECK(form == d[p] - ratio(1, 4));
  }
}

TEST_CASE("truth: an outward inset keeps w >= 0") {
  const Truth truth = Truth::of_clip(DepthRange::zero_to_one).inset(-0.5);
  CHECK(truth.half_spaces().size() == 7);
  CHECK(sign(truth.half_spaces().back().form, {{0, 0, 0, -0.25}, {}}) == -1);
}

TEST_CASE("truth: a frustum that encloses no volume is refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Frustum<double> f = unit_frustum();
  SECTION("left = right") { f.left = f.right; }
  SECTION("near = far") { f.near = f.far; }
  SECTION("near = 0") { f.near = 0; }
  SECTION("NaN") { f.top = nan; }
  SECTION("parallel without a far plane") {
    f.kind = ProjectionKind::parallel;
    f.infinite_far = true;
  }
  CHECK_THROWS_AS(Truth::of_frustum(f), std::invalid_argument);
}

// 1 + 2^-53 isn't a double: products and sums decide beyond what doubles can.
TEST_CASE("truth: the sign of a form is exact") {
  const LinearForm form = {{1, 0}, {1, 1}, {-1, 2}};  // x + y - z
  CHECK(sign(form, at(1, 0x1p-60, 1)) == 1);
  CHECK(sign(form, at(1, -0x1p-60, 1)) == -1);
  CHECK(sign(form, at(1, 0x1p-60, 1 + 0x1p-52)) == -1);
  CHECK(sign(form, at(0.1, 0.2, 0.1 + 0.2)) == -1);  // the sum is rounded up
  CHECK(sign(form, at(0.5, 0.25, 0.75)) == 0);
}

TEST_CASE("truth: underflow and overflow don't deceive the sign of a form") {
  const LinearForm product = {{0x1p-600, 0}, {-0x1p-600, 1}};
  CHECK(sign(product, at(0x1p-600, 0, 0)) == 1);
  CHECK(sign(product, at(0, 0x1p-600, 0)) == -1);
  CHECK(sign(product, at(0x1p-600, 0x1p-600, 0)) == 0);
  const LinearForm huge = {{0x1p1000, 0}, {-0x1p1000, 1}};
  CHECK(sign(huge, at(0x1p1000, 0x1p999, 0)) == 1);
  CHECK(sign(huge, at(0x1p999, 0x1p1000, 0)) == -1);
}

// d is the smallest double: 0.6 d + 0.6 d - 1.3 d < 0, but each product is rounded to d.
TEST_CASE("truth: products that underflow together don't deceive the sign of a form") {
  const double root = 0x1p-537;
  const LinearForm form = {{root * 0.6, 0}, {root * 0.6, 1}, {root * 1.3, 2}};
  CHECK(sign(form, at(root, root, -root)) == -1);
}

TEST_CASE("truth: a form without terms is 0") { CHECK(sign({}, at(1, 1, 1)) == 0); }

// The last term takes back what double arithmetic makes of the others: rounding errors remain.
TEST_CASE("truth: the filter decides as exact arithmetic does where sums cancel") {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int deceived = 0;
  for (int i = 0; i < 20000; ++i) {
    const InputVertex v = at(uniform(random), uniform(random), uniform(random));
    LinearForm form;
    double sum = 0;
    for (int c = 0; c < 3; ++c) {
      form.push_back({uniform(random), c});
      sum += form[c].coefficient * v.position[c];
    }
    form.insert(form.begin(), {-sum, kOne});
    double rounded = 0;
    for (const Term& term : form) {
      rounded += term.coefficient * (term.coordinate == kOne ? 1 : v.position[term.coordinate]);
    }
    const int exact = static_cast<int>(value(form, v).sign());
    REQUIRE(sign(form, v) == exact);
    deceived += rounded * exact < 0 ? 1 : 0;
  }
  CHECK(deceived > 100);  // doubles alone would have been wrong
}

TEST_CASE("truth: NaN and infinity in use are not finite, out of use they don't matter") {
  InputTriangle t = triangle({0, 0, -2, 1}, {1, 0, -2, 1}, {0, 1, -2, 1});
  CHECK(is_finite(t));
  t.vertices[1].attributes[3] = std::numeric_limits<double>::infinity();
  CHECK(is_finite(t));
  t.attribute_count = 4;
  CHECK_FALSE(is_finite(t));
  t.attribute_count = 0;
  t.vertices[2].position[1] = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(is_finite(t));
}

}  // namespace
}  // namespace clipscope::reference

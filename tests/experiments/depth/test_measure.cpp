// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "experiments/depth/measure.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/selection/select.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::depth;
using reference::Rational;

namespace {

const Convention& convention(std::string_view name) {
  for (const Convention& c : kConventions) {
    if (c.name == name) return c;
  }
  throw std::logic_error("no such convention");
}

Buffer buffer(std::string_view name, Stored format, Arithmetic arithmetic = Arithmetic::in_double,
              float near = 1, float far = 4) {
  return Buffer(convention(name), format, arithmetic, near, far);
}

reference::Rational fraction(int numerator, int denominator) {
  return reference::Rational(numerator) / reference::Rational(denominator);
}

FormRow find(const std::vector<FormRow>& checks, Form form, std::string_view property,
             std::string_view arithmetic = "exact") {
  const auto found = std::ranges::find_if(checks, [&](const FormRow& c) {
    return c.form == form && c.property == property && c.arithmetic == arithmetic;
  });
  REQUIRE(found != checks.end());
  return *found;
}

std::vector<FormRow> checks_of(float near, float far) {
  Random random(1);
  return check_forms(near, far, 200, random);
}

// The largest deviation of an edge from near to far in the quadratic form: 2 (sqrt(r) - 1) /
// (sqrt(r) + 1) with r = far / near, in NDC. At the screen parameter s the edge's point has the
// parameter t = s / (s + (1 - s) r), and s - t is largest at s = sqrt(r) / (1 + sqrt(r)).
double largest_line_deviation(double far_near_ratio) {
  const double root = std::sqrt(far_near_ratio);
  return 2 * (root - 1) / (root + 1);
}

}  // namespace

TEST_CASE("depth buffer: depth is exact at distances that can be checked by hand") {
  // near 1, far 4: z_ndc = 4/3 (d - 1) / d for [0, 1].
  CHECK(buffer("zero_to_one", Stored::float32).exact(2) == fraction(2, 3));
  CHECK(buffer("gl", Stored::float32).exact(2) == fraction(2, 3));
  CHECK(buffer("reversed", Stored::float32).exact(2) == fraction(1, 3));
  CHECK(buffer("zero_to_one_infinite", Stored::float32).exact(2) == fraction(1, 2));
  CHECK(buffer("gl_infinite", Stored::float32).exact(2) == fraction(1, 2));
  CHECK(buffer("reversed_infinite", Stored::float32).exact(2) == fraction(1, 2));
}

TEST_CASE("depth buffer: near and far are stored as the ends of the range") {
  for (const Stored format : kStored) {
    CHECK(buffer("gl", format).stored(1) < 1e-15);  // the matrix is rounded
    CHECK(buffer("gl", format).stored(4) == 1);
    CHECK(buffer("reversed", format).stored(1) == 1);
    CHECK(buffer("reversed", format).stored(4) == 0);
  }
}

TEST_CASE("depth buffer: codes grow with distance in every convention and format") {
  for (const Convention& c : kConventions) {
    for (const Stored format : kStored) {
      const Buffer b(c, format, Arithmetic::in_double, 1, 4);
      CHECK(b.code(1) < b.code(2));
      CHECK(b.code(2) < b.code(4));
    }
  }
}

TEST_CASE("depth buffer: double arithmetic is within half a step of the exact depth") {
  for (const Convention& c : kConventions) {
    const Buffer b(c, Stored::unorm24, Arithmetic::in_double, 0.1f, 1000);
    for (const float d : {0.1f, 0.3f, 7.0f, 912.0f}) CHECK(b.error_ulp(d) < 0.5001);
  }
}

TEST_CASE("resolution: a 16-bit buffer needs the steps of its hyperbola") {
  // [0, 1] with an infinite far plane: depth = 1 - n/d, so a step of 2^-16 at d is d^2 / n 2^-16.
  // Two points are surely told apart when their depths differ by one step.
  const Buffer b = buffer("zero_to_one_infinite", Stored::unorm16, Arithmetic::in_double, 1, 1000);
  for (const float d : {4.0f, 10.0f}) {
    const double step = d * d / 65535;
    const auto found = resolution(b, d);
    REQUIRE(found);
    CHECK(*found > 0.9 * step);
    CHECK(*found < 1.05 * step);
  }
}

TEST_CASE("resolution: points farther apart than it are told apart, nearer ones are not") {
  const Buffer b = buffer("zero_to_one", Stored::unorm24, Arithmetic::in_float, 0.1f, 1000);
  const double found = resolution(b, 100).value();
  CHECK(b.code(static_cast<float>(100 - found)) < b.code(100));
  int tied = 0;
  for (int i = 0; i < 64; ++i) {
    const auto d = static_cast<float>(100 - i / 64.0);
    tied += b.code(static_cast<float>(d - found / 8)) == b.code(d);
  }
  CHECK(tied > 0);
}

TEST_CASE("resolution: nothing where not even the near plane is told apart") {
  // 16 bits from 1 to 1.00001 at the hyperbola of an infinite far plane: 0.00001 is less than a
  // step.
  const Buffer b =
      buffer("zero_to_one_infinite", Stored::unorm16, Arithmetic::in_double, 1, 1.00001f);
  CHECK_FALSE(resolution(b, 1.00001f));
}

TEST_CASE("neighbours: ties and wrong orders are counted") {
  const Buffer b = buffer("zero_to_one", Stored::unorm16);
  const std::vector<float> tied = {2, std::nextafter(2.0f, 3.0f), 3};
  CHECK(order_of(b, tied).tied == 1);
  CHECK(order_of(b, tied).misordered == 0);
  CHECK(order_of(b, tied).distinct == 2);
  const std::vector<float> descending = {3, 2};
  CHECK(order_of(b, descending).misordered == 1);
}

TEST_CASE("neighbours: reversed float orders what [0, 1] in float does not, beyond far/near 1e4") {
  Random random(1);
  const std::vector<float> distances = spread_distances(0.1f, 1e4f, 2000, random);
  const auto lost = [&](std::string_view name) {
    const Order order =
        order_of(buffer(name, Stored::float32, Arithmetic::in_float, 0.1f, 1e4f), distances);
    return order.tied + order.misordered;
  };
  CHECK(lost("reversed") == 0);
  CHECK(lost("zero_to_one") > 10);
  CHECK(lost("gl") > 10);
}

TEST_CASE("spread distances: ascending, within the range, the same for a seed") {
  Random first(7), second(7);
  const std::vector<float> a = spread_distances(0.1f, 100, 500, first);
  CHECK(a == spread_distances(0.1f, 100, 500, second));
  CHECK(a.front() >= 0.1f);
  CHECK(a.back() <= 100);
  CHECK(std::ranges::adjacent_find(a, std::greater_equal<>{}) == a.end());
}

TEST_CASE("depth forms: both map near to -1 and far to 1") {
  for (const Form form : {Form::linear, Form::quadratic}) {
    CHECK(depth_ndc<Rational>(form, Rational(1), Rational(1), Rational(10)) == -1);
    CHECK(depth_ndc<Rational>(form, Rational(10), Rational(1), Rational(10)) == 1);
  }
}

TEST_CASE("depth forms: the quadratic one is proportional to distance") {
  CHECK(depth_ndc<Rational>(Form::quadratic, Rational(5), Rational(1), Rational(9)) == 0);
  CHECK_FALSE(depth_ndc<Rational>(Form::linear, Rational(5), Rational(1), Rational(9)) == 0);
}

TEST_CASE("depth forms: the linear one keeps order, straight lines and occlusion, exactly") {
  const auto checks = checks_of(1, 10);
  CHECK(find(checks, Form::linear, "monotone").violations == 0);
  CHECK(find(checks, Form::linear, "lines stay straight").violations == 0);
  CHECK(find(checks, Form::linear, "nearer wins").violations == 0);
}

TEST_CASE("depth forms: the quadratic one keeps order, bends lines and shows the farther of two") {
  const auto checks = checks_of(1, 10);
  CHECK(find(checks, Form::quadratic, "monotone").violations == 0);
  CHECK(find(checks, Form::quadratic, "lines stay straight").violations > 190);
  CHECK(find(checks, Form::quadratic, "nearer wins").violations > 0);
}

TEST_CASE("depth forms: no edge is bent by more than the edge from near to far") {
  const float far = GENERATE(2.0f, 10.0f, 1000.0f);
  const FormRow bent = find(checks_of(1, far), Form::quadratic, "lines stay straight");
  // sqrt is rounded to double, and so is the parameter that stands for it.
  CHECK(bent.max_deviation_ndc == Approx(largest_line_deviation(far)).epsilon(1e-12));
}

TEST_CASE("the point beside the eye has w = 0 in every arithmetic and can't be divided") {
  const auto points = point_beside_the_eye();
  REQUIRE(points.size() == 3);
  for (const EyePlaneRow& p : points) {
    CHECK(p.x == 1);
    CHECK(p.y == 1);
    CHECK(p.z == Approx(-20.0 / 9).epsilon(1e-6));  // float
    CHECK(p.w == 0);
    CHECK_FALSE(p.divisible);
  }
}

TEST_CASE("depth: a scalar that it does not compute in is refused by name") {
  Selection selection;
  selection.scalars = {"exact"};
  CHECK_THROWS_AS(arithmetics_of(selection.scalars), UsageError);
  selection.scalars = {"exact", "double"};
  CHECK(arithmetics_of(selection.scalars) == std::vector{Arithmetic::in_double});
}

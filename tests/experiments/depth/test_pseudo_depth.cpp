// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "experiments/depth/pseudo_depth.hpp"
#include "experiments/depth/tables.hpp"
#include "experiments/errors.hpp"
#include "reference/fraction.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using reference::Rational;

namespace {

DepthCheck find(const std::vector<DepthCheck>& checks, std::string_view form,
                std::string_view property, std::string_view arithmetic = "exact") {
  const auto found = std::ranges::find_if(checks, [&](const DepthCheck& c) {
    return c.form == form && c.property == property && c.arithmetic == arithmetic;
  });
  REQUIRE(found != checks.end());
  return *found;
}

std::vector<DepthCheck> checks_of(float near, float far) {
  Random random(1);
  return check_depth_forms(near, far, 200, random);
}

}  // namespace

TEST_CASE("depth forms: both map near to -1 and far to 1") {
  for (const DepthForm form : {DepthForm::linear, DepthForm::quadratic}) {
    CHECK(depth_ndc<Rational>(form, Rational(1), Rational(1), Rational(10)) == -1);
    CHECK(depth_ndc<Rational>(form, Rational(10), Rational(1), Rational(10)) == 1);
  }
}

TEST_CASE("depth forms: the quadratic one is proportional to distance") {
  CHECK(depth_ndc<Rational>(DepthForm::quadratic, Rational(5), Rational(1), Rational(9)) == 0);
  CHECK_FALSE(depth_ndc<Rational>(DepthForm::linear, Rational(5), Rational(1), Rational(9)) == 0);
}

TEST_CASE("depth forms: the linear one keeps order, straight lines and occlusion, exactly") {
  const auto checks = checks_of(1, 10);
  CHECK(find(checks, "linear", "monotone").violations == 0);
  CHECK(find(checks, "linear", "lines stay straight").violations == 0);
  CHECK(find(checks, "linear", "nearer wins").violations == 0);
}

TEST_CASE("depth forms: the quadratic one keeps order, bends lines and shows the farther of two") {
  const auto checks = checks_of(1, 10);
  CHECK(find(checks, "quadratic", "monotone").violations == 0);
  CHECK(find(checks, "quadratic", "lines stay straight").violations > 190);
  CHECK(find(checks, "quadratic", "nearer wins").violations > 0);
}

TEST_CASE("depth forms: no edge is bent by more than the edge from near to far") {
  const float far = GENERATE(2.0f, 10.0f, 1000.0f);
  const DepthCheck bent = find(checks_of(1, far), "quadratic", "lines stay straight");
  // sqrt is rounded to double, and so is the parameter that stands for it.
  CHECK(bent.deviation_ndc == Approx(largest_line_deviation(far)).epsilon(1e-12));
}

TEST_CASE("the point beside the eye has w = 0 in every arithmetic and can't be divided") {
  const auto points = point_beside_the_eye();
  REQUIRE(points.size() == 3);
  for (const EyePlanePoint& p : points) {
    CHECK(p.x == 1);
    CHECK(p.y == 1);
    CHECK(p.z == Approx(-20.0 / 9).epsilon(1e-6));  // float
    CHECK(p.w == 0);
    CHECK_FALSE(p.finite_ndc);
  }
}

TEST_CASE("depth: a scalar that it does not compute in is refused by name") {
  Selection selection;
  selection.scalars = {"exact"};
  CHECK_THROWS_AS(depth_arithmetics(selection), UsageError);
  selection.scalars = {"exact", "double"};
  CHECK(depth_arithmetics(selection) == std::vector{DepthArithmetic::in_double});
}

TEST_CASE("depth: the finding follows the rows") {
  Table precision = depth_precision_table(), forms = depth_forms_table();
  CHECK(depth_finding(precision, forms).empty());
  DepthCheck check{"quadratic", "lines stay straight", "exact", 10, 10, 1.25, 3};
  add_form_rows(forms, 10, std::span(&check, 1));
  CHECK_THAT(depth_finding(precision, forms), Catch::Contains("1.25"));
}

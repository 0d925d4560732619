// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "experiments/depth/depth_precision.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

const DepthConvention& convention(std::string_view name) {
  for (const DepthConvention& c : kDepthConventions) {
    if (c.name == name) return c;
  }
  throw std::logic_error("no such convention");
}

DepthBuffer buffer(std::string_view name, DepthFormat format,
                   DepthArithmetic arithmetic = DepthArithmetic::in_double, float near = 1,
                   float far = 4) {
  return DepthBuffer(convention(name), format, arithmetic, near, far);
}

reference::Rational fraction(int numerator, int denominator) {
  return reference::Rational(numerator) / reference::Rational(denominator);
}

}  // namespace

TEST_CASE("depth buffer: depth is exact at distances that can be checked by hand") {
  // near 1, far 4: z_ndc = 4/3 (d - 1) / d for [0, 1].
  CHECK(buffer("zero_to_one", DepthFormat::float32).exact(2) == fraction(2, 3));
  CHECK(buffer("gl", DepthFormat::float32).exact(2) == fraction(2, 3));
  CHECK(buffer("reversed", DepthFormat::float32).exact(2) == fraction(1, 3));
  CHECK(buffer("zero_to_one_infinite", DepthFormat::float32).exact(2) == fraction(1, 2));
  CHECK(buffer("gl_infinite", DepthFormat::float32).exact(2) == fraction(1, 2));
  CHECK(buffer("reversed_infinite", DepthFormat::float32).exact(2) == fraction(1, 2));
}

TEST_CASE("depth buffer: near and far are stored as the ends of the range") {
  for (const DepthFormat format : kDepthFormats) {
    CHECK(buffer("gl", format).stored(1) < 1e-15);  // the matrix is rounded
    CHECK(buffer("gl", format).stored(4) == 1);
    CHECK(buffer("reversed", format).stored(1) == 1);
    CHECK(buffer("reversed", format).stored(4) == 0);
  }
}

TEST_CASE("depth buffer: codes grow with distance in every convention and format") {
  for (const DepthConvention& c : kDepthConventions) {
    for (const DepthFormat format : kDepthFormats) {
      const DepthBuffer b(c, format, DepthArithmetic::in_double, 1, 4);
      CHECK(b.code(1) < b.code(2));
      CHECK(b.code(2) < b.code(4));
    }
  }
}

TEST_CASE("depth buffer: double arithmetic is within half a step of the exact depth") {
  for (const DepthConvention& c : kDepthConventions) {
    const DepthBuffer b(c, DepthFormat::unorm24, DepthArithmetic::in_double, 0.1f, 1000);
    for (const float d : {0.1f, 0.3f, 7.0f, 912.0f}) CHECK(b.error_ulp(d) < 0.5001);
  }
}

TEST_CASE("resolution: a 16-bit buffer needs the steps of its hyperbola") {
  // [0, 1] with an infinite far plane: depth = 1 - n/d, so a step of 2^-16 at d is d^2 / n 2^-16. Two points
  // are surely told apart when their depths differ by one step.
  const DepthBuffer b =
      buffer("zero_to_one_infinite", DepthFormat::unorm16, DepthArithmetic::in_double, 1, 1000);
  for (const float d : {4.0f, 10.0f}) {
    const double step = d * d / 65535;
    const auto found = resolution(b, d);
    REQUIRE(found);
    CHECK(*found > 0.9 * step);
    CHECK(*found < 1.05 * step);
  }
}

TEST_CASE("resolution: points farther apart than it are told apart, nearer ones are not") {
  const DepthBuffer b =
      buffer("zero_to_one", DepthFormat::unorm24, DepthArithmetic::in_float, 0.1f, 1000);
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
  // 16 bits from 1 to 1.00001 at the hyperbola of an infinite far plane: 0.00001 is less than a step.
  const DepthBuffer b =
      buffer("zero_to_one_infinite", DepthFormat::unorm16, DepthArithmetic::in_double, 1, 1.00001f);
  CHECK_FALSE(resolution(b, 1.00001f));
}

TEST_CASE("neighbours: ties and wrong orders are counted") {
  const DepthBuffer b = buffer("zero_to_one", DepthFormat::unorm16);
  const std::vector<float> tied = {2, std::nextafter(2.0f, 3.0f), 3};
  CHECK(neighbour_order(b, tied).tied == 1);
  CHECK(neighbour_order(b, tied).misordered == 0);
  CHECK(distinct_values(b, tied) == 2);
  const std::vector<float> descending = {3, 2};
  CHECK(neighbour_order(b, descending).misordered == 1);
}

TEST_CASE("neighbours: reversed float orders what [0, 1] in float does not, beyond far/near 1e4") {
  Random random(1);
  const std::vector<float> distances = spread_distances(0.1f, 1e4f, 2000, random);
  const auto lost = [&](std::string_view name) {
    const NeighbourOrder order = neighbour_order(
        buffer(name, DepthFormat::float32, DepthArithmetic::in_float, 0.1f, 1e4f), distances);
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

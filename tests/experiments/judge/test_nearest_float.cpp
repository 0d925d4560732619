// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rounding to float where rounding twice goes wrong.
#include <cmath>
#include <limits>
#include <random>

#include "experiments/judge/compare.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

const double kMiddle = 1.0 + 0x1p-24;         // between 1 and the next float, which is odd
const double kOddMiddle = 1.0 + 3 * 0x1p-24;  // between that and the one after, which is even

Exact exactly(double high, double low) { return Exact(Exact(high) + Exact(low)); }

template <class T>
float nearest_float(const T& x) {
  Answers answers(kFormat<T>, 4);
  for (int i = 0; i < 4; ++i) answers.add(x);
  answers.end_polygon();
  return experiments::nearest_float(answers[0][0][0], kFormat<T>);
}

}  // namespace

TEST_CASE("nearest float: just beside the middle the low part decides, not the double") {
  for (const double tiny : {0x1p-80, 0x1p-100}) {
    CHECK(nearest_float(dd_real(kMiddle, tiny)) == 1.0f + 0x1p-23f);
    CHECK(nearest_float(dd_real(kMiddle, -tiny)) == 1.0f);
    CHECK(nearest_float(exactly(kMiddle, tiny)) == 1.0f + 0x1p-23f);
    CHECK(nearest_float(exactly(kMiddle, -tiny)) == 1.0f);
    CHECK(nearest_float(exactly(-kMiddle, -tiny)) == -1.0f - 0x1p-23f);
    CHECK(nearest_float(dd_real(kOddMiddle, tiny)) == 1.0f + 0x1p-22f);
    CHECK(nearest_float(dd_real(kOddMiddle, -tiny)) == 1.0f + 0x1p-23f);
  }
}

TEST_CASE("nearest float: ties go to even") {
  CHECK(nearest_float(Exact(kMiddle)) == 1.0f);
  CHECK(nearest_float(dd_real(kMiddle)) == 1.0f);
  CHECK(nearest_float(Exact(kOddMiddle)) == 1.0f + 0x1p-22f);
  CHECK(nearest_float(Exact(-kOddMiddle)) == -1.0f - 0x1p-22f);
}

TEST_CASE("nearest float: zero, subnormals and overflow") {
  CHECK(nearest_float(Exact(0)) == 0.0f);
  const double half = std::ldexp(1.0, -150);  // of the smallest float
  CHECK(nearest_float(exactly(half, half * 0x1p-52)) == std::numeric_limits<float>::denorm_min());
  CHECK(nearest_float(Exact(half)) == 0.0f);
  CHECK(std::isinf(nearest_float(Exact(1e300))));
  CHECK(std::isnan(nearest_float(std::nan(""))));
}

TEST_CASE("nearest float: agrees with the reference's rounding on random numbers near middles") {
  std::mt19937_64 generator(3);
  for (int i = 0; i < 20000; ++i) {
    const double middle = std::ldexp(static_cast<double>(generator() % 0x2000000), -24);
    const double low = std::ldexp(static_cast<double>(generator() % 5) - 2, -90);
    const clipscope::reference::Fraction fraction{
        clipscope::reference::Dyadic(middle) + clipscope::reference::Dyadic(low), 1};
    const float expected = clipscope::reference::round_to<float>(fraction);
    REQUIRE(nearest_float(exactly(middle, low)) == expected);
    if (middle != 0) REQUIRE(nearest_float(dd_real(middle, low)) == expected);
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/table/hex_float.hpp"

#include <limits>

#include "tests/catch.hpp"

using clipscope::experiments::hex_float;
using Float = std::numeric_limits<float>;
using Double = std::numeric_limits<double>;

TEST_CASE("hex floats: both zeros have the exponent 0") {
  CHECK(hex_float(0.0) == "0x0p+0");
  CHECK(hex_float(-0.0) == "-0x0p+0");
  CHECK(hex_float(-0.0f) == "-0x0p+0");
}

TEST_CASE("hex floats: digits are as few as the number has") {
  CHECK(hex_float(1) == "0x1p+0");
  CHECK(hex_float(-0.1) == "-0x1.999999999999ap-4");
  CHECK(hex_float(0.1f) == "0x1.99999ap-4");
  CHECK(hex_float(Float::max()) == "0x1.fffffep+127");
  CHECK(hex_float(Double::max()) == "0x1.fffffffffffffp+1023");
}

TEST_CASE("hex floats: a float's subnormal begins with 1, a double's with 0") {
  CHECK(hex_float(Float::denorm_min()) == "0x1p-149");
  CHECK(hex_float(-(Float::min() - Float::denorm_min())) == "-0x1.fffffcp-127");
  CHECK(hex_float(Double::denorm_min()) == "0x0.0000000000001p-1022");
  CHECK(hex_float(-Double::min()) == "-0x1p-1022");
}

TEST_CASE("hex floats: what is not finite is named") {
  CHECK(hex_float(Float::infinity()) == "inf");
  CHECK(hex_float(-Double::infinity()) == "-inf");
  CHECK(hex_float(Float::quiet_NaN()) == "nan");
}

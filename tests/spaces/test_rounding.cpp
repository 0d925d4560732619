// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rounding to float under -O3 with SLP vectorization, as users compile the clippers. By casts GCC
// 12 leaves two of these three values unrounded (test_compiler.cpp).
#include "spaces/rounding.hpp"

#include <array>
#include <cstddef>

#include "tests/catch.hpp"

namespace clipscope {
namespace {

[[gnu::noinline]] std::array<double, 4> rounded(double factor,
                                                const std::array<double, 4>& values) {
  std::array<double, 4> r{0, 0, 0, 1};
  for (std::size_t c = 0; c < 3; ++c) r[c] = rounded_to_float(factor * values[c]);
  return r;
}

}  // namespace

TEST_CASE("rounding: what is rounded to float and read as double is a float") {
  const std::array<double, 4> r = rounded(1.1, {0.1, 0.2, 0.3, 0.7});
  CHECK(r[0] == 0x1.c28f5cp-4);
  CHECK(r[1] == 0x1.c28f5cp-3);
  CHECK(r[2] == 0x1.51eb86p-2);
}

TEST_CASE("rounding: ties go to even, also where the compiler computes") {
  static_assert(rounded_to_float(1 + 0x1p-24) == 1.0f);
  static_assert(rounded_to_float(1 + 0x3p-24) == 1 + 0x1p-22f);
  CHECK(rounded_to_float(1 + 0x1p-24) == 1.0f);
  CHECK(rounded_to_float(1 + 0x3p-24) == 1 + 0x1p-22f);
}

}  // namespace clipscope

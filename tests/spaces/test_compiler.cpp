// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tests and scenes take for granted of the compiler: that a rounding that is written is
// done.
#include <array>
#include <cstddef>

#include "tests/catch.hpp"

namespace {

// GCC 12 with -ftree-slp-vectorize leaves two of the three values unrounded.
[[gnu::noinline]] std::array<double, 4> rounded_to_floats(double factor,
                                                          const std::array<double, 4>& values) {
  std::array<double, 4> r{0, 0, 0, 1};
  for (std::size_t c = 0; c < 3; ++c) {
    r[c] = static_cast<double>(static_cast<float>(factor * values[c]));
  }
  return r;
}

}  // namespace

TEST_CASE("compiler: what is converted to float and back is a float") {
  const std::array<double, 4> r = rounded_to_floats(1.1, {0.1, 0.2, 0.3, 0.7});
  CHECK(r[0] == 0x1.c28f5cp-4);
  CHECK(r[1] == 0x1.c28f5cp-3);
  CHECK(r[2] == 0x1.51eb86p-2);
}

// SPDX-License-Identifier: MIT
//
// A double rounded to the nearest float, ties to even, under every compiler.
//
// GCC before version 13 vectorizes neighbouring conversions double -> float -> double (-O2 and -O3:
// -ftree-slp-vectorize) and then takes the pair of vector conversions for nothing, so that the
// rounding is lost. To these compilers what comes out here is opaque; that costs no instruction.
#pragma once

#include <type_traits>

namespace clipscope {

constexpr float rounded_to_float(double x) {
  float r = static_cast<float>(x);
#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ < 13
  if (!std::is_constant_evaluated()) {
#if defined(__SSE__)
    asm("" : "+x"(r));
#elif defined(__aarch64__)
    asm("" : "+w"(r));
#else
    asm("" : "+m"(r));
#endif
  }
#endif
  return r;
}

}  // namespace clipscope

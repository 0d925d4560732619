// SPDX-License-Identifier: GPL-3.0-or-later
//
// What libFuzzer calls: the harness CLIPSCOPE_HARNESS.
#include <cstddef>

#include "tests/fuzz/harness.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  clipscope::fuzz::CLIPSCOPE_HARNESS({data, size});
  return 0;
}

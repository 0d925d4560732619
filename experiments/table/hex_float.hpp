// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers as hex floats, to the bit. The text is that of C's "%a" for the number as a double; fmt's
// "{:a}" is the same up to version 9, and writes zero as 0x0p-1022 from 10 on.
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

namespace clipscope::experiments {

// "0x1.8p+1"; "0x0p+0" and "-0x0p+0" for the zeros; "inf", "-inf", "nan" or "-nan" (with its sign
// bit set).
inline std::string hex_float(double x) {
  char text[32];
  const int size = std::snprintf(text, sizeof text, "%a", x);
  return {text, static_cast<std::size_t>(size)};
}

}  // namespace clipscope::experiments

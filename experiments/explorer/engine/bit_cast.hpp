// SPDX-License-Identifier: GPL-3.0-or-later
//
// std::bit_cast for a standard library that lacks it: libc++ before 14, which emscripten 3.1.6
// brings. Read before every other header (-include), so that spaces/ stays as it is.
#pragma once

#include <bit>

#if !defined(__cpp_lib_bit_cast)
namespace std {
template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}
}  // namespace std
#endif

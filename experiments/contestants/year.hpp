// SPDX-License-Identifier: GPL-3.0-or-later
//
// When a clipper's method was published.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace clipscope::experiments {

// The year that a clipper's source ends with: that of its publication. None where it ends
// otherwise: with a specification's section, say.
inline std::optional<int> year_of(std::string_view source) {
  constexpr std::size_t kDigits = 4;
  if (source.size() < kDigits) return std::nullopt;
  const std::string_view digits = source.substr(source.size() - kDigits);
  const char* const end = digits.data() + kDigits;
  int year = 0;
  const auto [read, error] = std::from_chars(digits.data(), end, year);
  return error == std::errc{} && read == end ? std::optional(year) : std::nullopt;
}

}  // namespace clipscope::experiments

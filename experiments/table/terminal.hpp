// SPDX-License-Identifier: GPL-3.0-or-later
//
// How wide a text for a terminal is.
#pragma once

#include <cstddef>
#include <string>

namespace clipscope::experiments {

inline constexpr std::size_t kTextWidth = 100;  // columns

// The text in lines of at most kTextWidth characters, each indented by two.
std::string indented(const std::string& text);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The texts of guests (their names, what they say of themselves), which contestants refer to.
#pragma once

#include <string>
#include <string_view>

namespace clipscope::experiments {

// The same text; it lives as long as the program does. For one thread at a time.
std::string_view kept_text(std::string text);

}  // namespace clipscope::experiments

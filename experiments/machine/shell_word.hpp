// SPDX-License-Identifier: GPL-3.0-or-later
//
// Commands that people copy into a shell.
#pragma once

#include <string>

namespace clipscope::experiments {

// The text as one word of a command, in quotes where it needs them.
std::string shell_word(const std::string& text);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texts made safe for files that must be UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace clipscope::experiments {

// The text with each byte that belongs to no well-formed UTF-8 sequence (RFC 3629: no overlong forms, no
// surrogates, none past U+10FFFF) replaced by U+FFFD.
std::string valid_utf8(std::string_view text);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texts and files as parts of an HTML or XML page.
#pragma once

#include <string>
#include <string_view>

namespace clipscope::experiments {

// The text as character data or as a quoted attribute: & < > " ' escaped, what is not UTF-8 replaced by
// U+FFFD, control characters that XML forbids by blanks.
std::string html_escape(std::string_view text);

// Base64 (RFC 4648), padded, in one line.
std::string base64(std::string_view bytes);

}  // namespace clipscope::experiments

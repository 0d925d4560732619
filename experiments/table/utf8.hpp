// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texts in UTF-8: made valid, made visible, measured, broken into lines, quoted.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace clipscope::experiments {

// The text with each byte that belongs to no well-formed UTF-8 sequence (RFC 3629: no overlong
// forms, no surrogates, none past U+10FFFF) replaced, by U+FFFD unless told otherwise.
std::string valid_utf8(std::string_view text, std::string_view replacement = "\xEF\xBF\xBD");

// The text with what people can't see, or take for an ASCII character, named: control characters,
// blanks and marks beyond ASCII, dashes, such as "<U+00A0 no-break space>", and bytes of no
// well-formed sequence, such as "<0xFF>".
std::string visible_utf8(std::string_view text);

// Code points: the columns of a terminal that a text without wide characters takes.
std::size_t character_count(std::string_view text);

// The words of a text in lines of at most `width` characters; one line where it is 0. A word that
// is longer breaks behind its hyphens alone.
std::vector<std::string> wrapped(const std::string& text, std::size_t width);

// As the text or the value of an attribute in XML and HTML. What these can't hold, control
// characters and bytes of no well-formed sequence, becomes U+FFFD; line breaks and tabs, which
// would become blanks in an attribute, stay.
std::string xml_escaped(std::string_view text);

// In double quotes, those within it doubled, as CSV and SQL have it.
std::string double_quoted(std::string_view text);

}  // namespace clipscope::experiments

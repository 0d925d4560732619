// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/table/utf8.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <sstream>
#include <utility>

namespace clipscope::experiments {
namespace {

constexpr const char* kReplacement = "\xEF\xBF\xBD";  // U+FFFD

// The bytes of the well-formed sequence that the text begins with; 0 if it begins with none.
std::size_t sequence_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xF0 ? 4 : (lead >= 0xE0 ? 3 : 2);
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  const unsigned second = byte(1);
  const bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
  const bool beyond = (lead == 0xED && second > 0x9F) || (lead == 0xF4 && second > 0x8F);
  return overlong || beyond ? 0 : length;
}

// The code point of a well-formed sequence.
char32_t code_point(std::string_view sequence) {
  if (sequence.size() == 1) return static_cast<unsigned char>(sequence[0]);
  char32_t code = static_cast<unsigned char>(sequence[0]) & (0x7Fu >> sequence.size());
  for (const char c : sequence.substr(1)) {
    code = code << 6 | (static_cast<unsigned char>(c) & 0x3Fu);
  }
  return code;
}

// Code points that look like nothing, like a blank or like a character of ASCII.
struct Lookalikes {
  char32_t first, last;
  const char* name;
};
constexpr Lookalikes kLookalikes[] = {{0x00, 0x1F, "control character"},
                                      {0x7F, 0x9F, "control character"},
                                      {0xA0, 0xA0, "no-break space"},
                                      {0xAD, 0xAD, "soft hyphen"},
                                      {0x2000, 0x200A, "wide or narrow space"},
                                      {0x200B, 0x200B, "zero-width space"},
                                      {0x200C, 0x200F, "mark without width"},
                                      {0x2010, 0x2015, "dash"},
                                      {0x2028, 0x2029, "line separator"},
                                      {0x202A, 0x202E, "mark without width"},
                                      {0x202F, 0x202F, "narrow no-break space"},
                                      {0x205F, 0x205F, "mathematical space"},
                                      {0x2060, 0x2064, "mark without width"},
                                      {0x2212, 0x2212, "minus sign"},
                                      {0x3000, 0x3000, "ideographic space"},
                                      {0xFEFF, 0xFEFF, "byte order mark"}};

}  // namespace

std::string valid_utf8(std::string_view text, std::string_view replacement) {
  std::string valid;
  while (!text.empty()) {
    const std::size_t length = sequence_length(text);
    valid += length == 0 ? replacement : text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return valid;
}

std::string visible_utf8(std::string_view text) {
  std::string visible;
  while (!text.empty()) {
    const std::size_t length = sequence_length(text);
    const std::string_view sequence = text.substr(0, std::max<std::size_t>(1, length));
    text.remove_prefix(sequence.size());
    if (length == 0) {
      visible += fmt::format("<0x{:02X}>", static_cast<unsigned char>(sequence[0]));
      continue;
    }
    const char32_t code = code_point(sequence);
    const auto found = std::ranges::find_if(
        kLookalikes, [&](const Lookalikes& l) { return l.first <= code && code <= l.last; });
    if (found == std::end(kLookalikes)) {
      visible += sequence;
    } else {
      visible += fmt::format("<U+{:04X} {}>", static_cast<unsigned>(code), found->name);
    }
  }
  return visible;
}

std::size_t character_count(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

namespace {

// A word that does not fit a line may break behind its hyphens.
std::vector<std::string> pieces_of(const std::string& word, std::size_t width) {
  if (character_count(word) <= width) return {word};
  std::vector<std::string> pieces(1);
  for (std::size_t i = 0; i < word.size(); ++i) {
    pieces.back() += word[i];
    if (word[i] == '-' && i + 1 < word.size()) pieces.emplace_back();
  }
  return pieces;
}

}  // namespace

std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
  if (width == 0 || character_count(text) <= width) return {text};
  std::vector<std::string> lines(1);
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    std::string blank = lines.back().empty() ? "" : " ";
    for (const std::string& piece : pieces_of(word, width)) {
      const std::string more = std::exchange(blank, "") + piece;
      if (lines.back().empty() || character_count(lines.back() + more) <= width) {
        lines.back() += more;
      } else {
        lines.push_back(piece);
      }
    }
  }
  return lines;
}

std::string xml_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : valid_utf8(text)) {
    switch (c) {
      case '&': escaped += "&amp;"; break;
      case '<': escaped += "&lt;"; break;
      case '>': escaped += "&gt;"; break;
      case '"': escaped += "&quot;"; break;
      case '\'': escaped += "&#39;"; break;
      case '\n': escaped += "&#10;"; break;
      case '\t': escaped += "&#9;"; break;
      default:
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
          escaped += kReplacement;
        } else {
          escaped += c;
        }
    }
  }
  return escaped;
}

std::string double_quoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

}  // namespace clipscope::experiments

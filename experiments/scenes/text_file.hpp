// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the readers of files share: words of text, numbers in text and in bytes, and complaints that
// name the file and the place in it.
//
// Every text that people bring comes in through TextFile, or at least through without_mark. It is
// ASCII or UTF-8; a byte order mark in front is skipped, and lines end in LF, in CRLF or in CR.
#pragma once

#include <fmt/core.h>

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "experiments/machine/errors.hpp"
#include "experiments/table/utf8.hpp"

namespace clipscope::experiments {

// Throws InputError "PLACE: MESSAGE". The place is a file, maybe with a line or an element of it.
// What can't be seen in the message, such as a no-break space in a word, is named.
template <class... Args>
[[noreturn]] void refuse(std::string_view place, fmt::format_string<Args...> message,
                         Args&&... args) {
  const std::string text = fmt::format(message, std::forward<Args>(args)...);
  throw InputError(fmt::format("{}: {}", place, visible_utf8(text)));
}

// The text behind its UTF-8 byte order mark, if it has one. Errors: InputError for UTF-16 and
// UTF-32 in either byte order, which a mark or zeros between the first characters give away.
std::string_view without_mark(const std::string& name, std::string_view text);

// What a text may hold beside words, blanks and line ends; '\0': no such thing.
struct TextForm {
  char separator = '\0';     // separates words as blanks do, such as ','
  char comment = '\0';       // begins a comment, which ends with its line
  char continuation = '\0';  // ends a line that goes on in the next one
};

// Reads a text line by line into words.
class TextFile {
 public:
  // Reads `text`, called `name` in messages; both must outlive the reader. Errors: those of
  // without_mark.
  TextFile(const std::string& name, std::string_view text, TextForm form = {});

  // Splits the next line into its words; false at the end of the text.
  bool next_line();
  // The same for the next line that has a word.
  bool next_words();

  const std::vector<std::string_view>& words() const { return words_; }
  std::string_view word(std::size_t i) const { return words_[i]; }
  // The number of the line, counted from 1; of a continued line its first.
  std::size_t line() const { return line_; }
  // What comes after the line. Where the first line ends in CR alone, all do, and an LF after the
  // CR is not part of the line end: it may be the first byte of a binary file's body.
  std::string_view rest() const { return rest_; }

  // Fails unless the line has n words; `pattern` shows what was expected.
  void require_words(std::size_t n, const char* pattern) const;
  // Word i as a number, which may be infinite or NaN, or fails: `name`, such as 'x', of `what`.
  double number(std::size_t i, char name, const char* what) const;
  // The word as a whole number, or fails.
  long long require_integer(std::string_view word, const char* what) const;

  // "FILE:LINE".
  std::string place() const { return fmt::format("{}:{}", name_, line_); }

  template <class... Args>
  [[noreturn]] void fail(fmt::format_string<Args...> message, Args&&... args) const {
    fail_at(line_, fmt::format(message, std::forward<Args>(args)...));
  }
  [[noreturn]] void fail_at(std::size_t line, const std::string& message) const;

 private:
  enum class Kind : unsigned char { word, blank, comment, line_end };

  Kind kind_of(char c) const { return kinds_[static_cast<unsigned char>(c)]; }
  bool append_line();
  void skip_line_end();

  const std::string& name_;
  std::string_view rest_;
  char continuation_;
  std::array<Kind, 256> kinds_ = {};  // of each character
  bool ends_in_cr_ = false;           // the lines
  std::vector<std::string_view> words_;
  std::size_t line_ = 0, lines_read_ = 0;
};

// A number in decimal, rounded once to double; infinite where it is too large for one.
std::optional<double> to_number(std::string_view word);
// The same, also of a C99 hex float such as -0x1p-2.
std::optional<double> to_number_or_hex(std::string_view word);
// The float nearest to the decimal number `word`, of which `nearest_double` is the nearest double:
// one rounding, not two.
float to_float(std::string_view word, double nearest_double);
std::optional<long long> to_integer(std::string_view word);

// The float nearest to a double; infinite where it is too large for one.
float nearest_float(double x);

// What is wrong with a coordinate: "NaN", "infinite" or "1e300, too large for a float"; empty if
// nothing is.
std::string defect_of(double coordinate);

// Throws InputError "SUBJECT is NaN; a finite number was expected" if something is wrong with it.
template <class Subject>
void require_finite(double coordinate, const Subject& subject) {
  const std::string defect = defect_of(coordinate);
  if (defect.empty()) return;
  throw InputError(fmt::format("{} is {}; a finite number was expected", subject(), defect));
}

// "1 vertex", "2 vertices".
template <std::integral N>
std::string counted(N n, const char* singular, const char* plural) {
  return fmt::format("{} {}", n, n == 1 ? singular : plural);
}

static_assert(std::endian::native == std::endian::little, "binary files are read as they are");

template <class T>
T value_at(std::string_view bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

// A type that numbers have in binary files.
struct NumberType {
  std::size_t bytes;
  bool is_integer, is_signed;
  double (*at)(std::string_view bytes, std::size_t offset);
};

template <class T>
inline constexpr NumberType kNumberType = {
    sizeof(T), std::is_integral_v<T>, std::is_signed_v<T>,
    [](std::string_view bytes, std::size_t offset) { return double(value_at<T>(bytes, offset)); }};

}  // namespace clipscope::experiments

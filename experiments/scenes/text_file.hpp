// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the readers of files share: words of text, numbers in text and in bytes, and complaints that
// name the file and the place in it.
#pragma once

#include <fmt/core.h>

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

namespace clipscope::experiments {

// Throws InputError "PLACE: MESSAGE". The place is a file, maybe with a line or an element of it.
template <class... Args>
[[noreturn]] void refuse(std::string_view place, fmt::format_string<Args...> message,
                         Args&&... args) {
  throw InputError(fmt::format("{}: {}", place, fmt::format(message, std::forward<Args>(args)...)));
}

// Reads a text line by line into words.
class TextFile {
 public:
  // Reads `text`, called `name` in messages; both must outlive the reader.
  TextFile(const std::string& name, std::string_view text) : name_(name), rest_(text) {}

  // Splits the next line into its words; false at the end of the text. A line that ends in
  // `continuation` and has no '#' comment goes on in the next line.
  bool next_line(char continuation = '\n');
  // The same for the next line that has a word.
  bool next_words(char continuation = '\n');

  const std::vector<std::string_view>& words() const { return words_; }
  std::string_view word(std::size_t i) const { return words_[i]; }
  // The number of the line, counted from 1; of a continued line its first.
  std::size_t line() const { return line_; }
  // What comes after the line.
  std::string_view rest() const { return rest_; }

  // Fails unless the line has n words; `pattern` shows what was expected.
  void require_words(std::size_t n, const char* pattern) const;
  // Fails unless there is a finite number within a float's range for each letter of `names`, such
  // as "xyz", from word `first` on; `what` names the thing they belong to.
  void require_numbers(std::size_t first, std::string_view names, const char* what) const;
  // The word as a whole number, or fails.
  long long require_integer(std::string_view word, const char* what) const;

  template <class... Args>
  [[noreturn]] void fail(fmt::format_string<Args...> message, Args&&... args) const {
    fail_at(line_, fmt::format(message, std::forward<Args>(args)...));
  }
  [[noreturn]] void fail_at(std::size_t line, const std::string& message) const;

 private:
  void append_line();
  bool ends_in(char continuation) const;

  const std::string& name_;
  std::string_view rest_;
  std::vector<std::string_view> words_;
  std::size_t line_ = 0, lines_read_ = 0;
};

std::optional<double> to_number(std::string_view word);
// The float nearest to the number. Pre-condition: it is a number that a float can hold.
float to_float(std::string_view word);
std::optional<long long> to_integer(std::string_view word);

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

template <class T>
void append_value(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
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

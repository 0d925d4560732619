// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads a text line by line into words, and complains about a place in it by file and line.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace clipscope::experiments {

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

  // Words first to first + count as finite numbers within a float's range, or fail: `what` names the
  // thing they belong to, `names` one letter for each, such as "xyz".
  void require_numbers(std::size_t first, std::string_view names, const char* what) const;
  // A word as a whole number, or fail.
  long long require_integer(std::string_view word, const char* what) const;

  [[noreturn]] void fail(const std::string& message) const { fail_at(line_, message); }
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

// "1 vertex", "2 vertices".
std::string counted(long long n, const char* singular, const char* plural);

}  // namespace clipscope::experiments

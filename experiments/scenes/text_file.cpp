// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/text_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace clipscope::experiments {
namespace {

constexpr std::string_view kBlanks = " \t\r\v\f";

// The number that is all of the word, and what was wrong with it.
template <class T>
std::pair<T, std::errc> parse(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  T value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool is_all = end == word.data() + word.size();
  return {value, is_all ? error : std::errc::invalid_argument};
}

}  // namespace

// Adds the words of the next line; the text must not be at its end.
void TextFile::append_line() {
  const std::size_t end = rest_.find('\n');
  std::string_view line = rest_.substr(0, end);
  rest_ = end == std::string_view::npos ? std::string_view{} : rest_.substr(end + 1);
  ++lines_read_;
  while (true) {
    const std::size_t start = line.find_first_not_of(kBlanks);
    if (start == std::string_view::npos) return;
    line.remove_prefix(start);
    words_.push_back(line.substr(0, line.find_first_of(kBlanks)));
    line.remove_prefix(words_.back().size());
  }
}

// Whether the words read so far end in that character, comments ('# ...') apart.
bool TextFile::ends_in(char continuation) const {
  const auto is_comment = [](std::string_view word) { return word[0] == '#'; };
  return !words_.empty() && words_.back().back() == continuation &&
         std::ranges::none_of(words_, is_comment);
}

bool TextFile::next_line(char continuation) {
  words_.clear();
  if (rest_.empty()) return false;
  append_line();
  line_ = lines_read_;
  while (ends_in(continuation) && !rest_.empty()) {
    words_.back().remove_suffix(1);
    if (words_.back().empty()) words_.pop_back();
    append_line();
  }
  return true;
}

bool TextFile::next_words(char continuation) {
  while (next_line(continuation)) {
    if (!words_.empty()) return true;
  }
  return false;
}

void TextFile::require_words(std::size_t n, const char* pattern) const {
  if (words_.size() != n) fail("'{}' expected", pattern);
}

void TextFile::require_numbers(std::size_t first, std::string_view names, const char* what) const {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (first + i >= words_.size()) fail("{} has {} of {} numbers", what, i, names.size());
    const std::string_view word = words_[first + i];
    const std::optional<double> number = to_number(word);
    if (!number) fail("{} of {} is '{}'; a number was expected", names[i], what, word);
    require_finite(*number,
                   [&] { return fmt::format("{}:{}: {} of {}", name_, line_, names[i], what); });
  }
}

long long TextFile::require_integer(std::string_view word, const char* what) const {
  const std::optional<long long> number = to_integer(word);
  if (!number) fail("{} is '{}'; a whole number was expected", what, word);
  return *number;
}

void TextFile::fail_at(std::size_t line, const std::string& message) const {
  refuse(fmt::format("{}:{}", name_, line), "{}", message);
}

std::optional<double> to_number(std::string_view word) {
  const auto [value, error] = parse<double>(word);
  if (error == std::errc::invalid_argument) return std::nullopt;
  if (error != std::errc::result_out_of_range) return value;
  const std::size_t exponent = word.find_first_of("eE");
  const bool tiny =
      exponent != std::string_view::npos && word.substr(exponent + 1).starts_with('-');
  return tiny ? 0.0 : std::numeric_limits<double>::infinity();
}

// A number that is too small even for a subnormal leaves 0.
float to_float(std::string_view word) { return parse<float>(word).first; }

std::optional<long long> to_integer(std::string_view word) {
  const auto [value, error] = parse<long long>(word);
  return error == std::errc{} ? std::optional(value) : std::nullopt;
}

std::string defect_of(double coordinate) {
  if (std::isnan(coordinate)) return "NaN";
  if (std::isinf(coordinate)) return "infinite";
  const bool is_float = std::abs(coordinate) <= double{std::numeric_limits<float>::max()};
  return is_float ? "" : fmt::format("{}, too large for a float", coordinate);
}

}  // namespace clipscope::experiments

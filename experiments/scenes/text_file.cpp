// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/text_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace clipscope::experiments {
namespace {

// Halfway between the largest float and what would be the next: what is below is rounded down.
constexpr double kTooLarge = 0x1.ffffffp127;

// The number that is all of the word, and what was wrong with it.
template <class T>
std::pair<T, std::errc> parse(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  T value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool is_all = end == word.data() + word.size();
  return {value, is_all ? error : std::errc::invalid_argument};
}

// How other encodings begin, with their marks or with the first characters of ASCII text: '0'
// stands for a zero byte, 'x' for any other.
struct Encoding {
  const char* name;
  std::string_view mark, zeros;
};
// The longer ones come first, since a UTF-32 mark begins as one of UTF-16 does.
constexpr Encoding kEncodings[] = {{"UTF-32 (little-endian)", {"\xFF\xFE\0\0", 4}, "x000"},
                                   {"UTF-32 (big-endian)", {"\0\0\xFE\xFF", 4}, "000x"},
                                   {"UTF-16 (little-endian)", "\xFF\xFE", "x0x0"},
                                   {"UTF-16 (big-endian)", "\xFE\xFF", "0x0x"}};

bool has_zeros(std::string_view text, std::string_view pattern) {
  const auto fits = [](char c, char wanted) { return (c == '\0') == (wanted == '0'); };
  return text.size() >= pattern.size() &&
         std::ranges::equal(text.substr(0, pattern.size()), pattern, fits);
}

}  // namespace

std::string_view without_mark(const std::string& name, std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  for (const auto& [encoding, mark, zeros] : kEncodings) {
    if (text.starts_with(mark) || has_zeros(text, zeros)) {
      refuse(name, "the text is {}; UTF-8 or ASCII expected", encoding);
    }
  }
  return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

TextFile::TextFile(const std::string& name, std::string_view text, TextForm form)
    : name_(name), rest_(without_mark(name, text)), continuation_(form.continuation) {
  const auto set = [this](char c, Kind kind) { kinds_[static_cast<unsigned char>(c)] = kind; };
  for (const char blank : {' ', '\t', '\v', '\f'}) set(blank, Kind::blank);
  for (const char end : {'\n', '\r'}) set(end, Kind::line_end);
  if (form.separator != '\0') set(form.separator, Kind::blank);
  if (form.comment != '\0') set(form.comment, Kind::comment);
  const std::size_t first_end = rest_.find_first_of("\r\n");
  ends_in_cr_ =
      first_end != rest_.npos && rest_[first_end] == '\r' && rest_.substr(first_end + 1, 1) != "\n";
}

// Adds the words of the next line, which must be there, and says whether it goes on in another.
bool TextFile::append_line() {
  const char *c = rest_.data(), *const end = c + rest_.size();
  const std::size_t before = words_.size();
  while (true) {
    c = std::find_if(c, end, [this](char x) { return kind_of(x) != Kind::blank; });
    const char* const start = c;
    c = std::find_if(c, end, [this](char x) { return kind_of(x) != Kind::word; });
    if (c == start) break;
    words_.emplace_back(start, static_cast<std::size_t>(c - start));
  }
  const bool has_comment = c != end && kind_of(*c) == Kind::comment;
  c = std::find_if(c, end, [this](char x) { return kind_of(x) == Kind::line_end; });
  rest_.remove_prefix(static_cast<std::size_t>(c - rest_.data()));
  skip_line_end();
  ++lines_read_;
  const bool goes_on = continuation_ != '\0' && !has_comment && words_.size() > before &&
                       words_.back().back() == continuation_ && !rest_.empty();
  if (!goes_on) return false;
  words_.back().remove_suffix(1);
  if (words_.back().empty()) words_.pop_back();
  return true;
}

void TextFile::skip_line_end() {
  const bool is_pair = !ends_in_cr_ && rest_.starts_with("\r\n");
  rest_.remove_prefix(std::min<std::size_t>(rest_.size(), is_pair ? 2 : 1));
}

bool TextFile::next_line() {
  words_.clear();
  if (rest_.empty()) return false;
  line_ = lines_read_ + 1;
  while (append_line()) {
  }
  return true;
}

bool TextFile::next_words() {
  while (next_line()) {
    if (!words_.empty()) return true;
  }
  return false;
}

void TextFile::require_words(std::size_t n, const char* pattern) const {
  if (words_.size() != n) fail("'{}' expected", pattern);
}

double TextFile::number(std::size_t i, char name, const char* what) const {
  const std::optional<double> number = to_number(words_[i]);
  if (!number) fail("{} of {} is '{}'; a number was expected", name, what, words_[i]);
  return *number;
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
  return std::strtod(std::string(word).c_str(), nullptr);  // 0 or infinite: from_chars says neither
}

std::optional<double> to_number_or_hex(std::string_view word) {
  const std::string_view digits = word.substr(word.find_first_not_of("+-") == 1 ? 1 : 0);
  if (!digits.starts_with("0x") && !digits.starts_with("0X")) return to_number(word);
  const std::string text(word);
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return end == text.c_str() + text.size() ? std::optional(value) : std::nullopt;
}

// Rounding to double and then to float gives the nearest float, unless the double lies halfway
// between two floats, to which its 24-bit neighbours are equally near: then the bits below the
// float's are 1 and 28 zeros, or the number is smaller than normal floats are. The text decides
// those.
float to_float(std::string_view word, double nearest_double) {
  constexpr std::uint64_t kBelowHalf = (std::uint64_t{1} << 28) - 1;
  const bool may_be_halfway = (std::bit_cast<std::uint64_t>(nearest_double) & kBelowHalf) == 0 ||
                              std::abs(nearest_double) < double{std::numeric_limits<float>::min()};
  const float rounded = nearest_float(nearest_double);
  if (!may_be_halfway || double{rounded} == nearest_double) return rounded;
  const auto [value, error] = parse<float>(word);
  return error == std::errc{} ? value : rounded;
}

std::optional<long long> to_integer(std::string_view word) {
  const auto [value, error] = parse<long long>(word);
  return error == std::errc{} ? std::optional(value) : std::nullopt;
}

float nearest_float(double x) {
  if (std::abs(x) < kTooLarge || std::isnan(x)) return static_cast<float>(x);
  return std::copysign(std::numeric_limits<float>::infinity(), static_cast<float>(x > 0 ? 1 : -1));
}

std::string defect_of(double coordinate) {
  if (std::isnan(coordinate)) return "NaN";
  if (std::isinf(coordinate)) return "infinite";
  const bool is_float = std::abs(coordinate) < kTooLarge;
  return is_float ? "" : fmt::format("{}, too large for a float", coordinate);
}

}  // namespace clipscope::experiments

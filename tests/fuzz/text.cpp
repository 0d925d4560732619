// SPDX-License-Identifier: GPL-3.0-or-later
//
// What people type or pipe in: primitives as text, hard cases, and their numbers, each rounded
// once.
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/commands/primitive_text.hpp"
#include "experiments/scenes/text_file.hpp"
#include "tests/fuzz/harness.hpp"

namespace clipscope::fuzz {
namespace {

using namespace experiments;
using namespace experiments::commands;

// Equal to the bit, NaN like NaN.
template <class T>
bool is_same(T a, T b) {
  return (std::isnan(a) && std::isnan(b)) || (a == b && std::signbit(a) == std::signbit(b));
}

// The word as the C library reads it; no number if that leaves some of it.
template <class T>
std::optional<T> by_c_library(const std::string& word) {
  char* end = nullptr;
  const T value = std::is_same_v<T, float> ? std::strtof(word.c_str(), &end)
                                           : static_cast<T>(std::strtod(word.c_str(), &end));
  return end == word.c_str() + word.size() ? std::optional(value) : std::nullopt;
}

// The word as the C++ library reads it, which shares nothing with C's; nothing where it leaves open
// whether the number is 0 or infinite.
template <class T>
std::optional<T> by_cpp_library(const std::string& word) {
  const std::size_t sign = word.starts_with('-') || word.starts_with('+') ? 1 : 0;
  const bool is_hex = word.substr(sign, 2) == "0x" || word.substr(sign, 2) == "0X";
  const char* const begin = word.data() + sign + (is_hex ? 2 : 0);
  T value = 0;
  const auto [end, error] =
      std::from_chars(begin, word.data() + word.size(), value,
                      is_hex ? std::chars_format::hex : std::chars_format::general);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return word.starts_with('-') ? -value : value;
}

// The numbers of mesh files and of cases.
void check_file_number(const std::string& word) {
  const std::optional<double> number = to_number_or_hex(word);
  if (!number) return;
  const auto expected = by_c_library<double>(word);
  require(expected && is_same(*number, *expected), "'{}' was read as {}; {} is right", word,
          *number, expected.value_or(NAN));
  if (!to_number(word)) return;
  const auto as_float = by_c_library<float>(word);
  const float read = to_float(word, *number);
  require(as_float && is_same(read, *as_float), "'{}' was read as the float {}; {} is right", word,
          read, as_float.value_or(NAN));
}

// The numbers of primitives.
template <class T>
void check_number(const std::string& word) {
  read_or_refuse([&] {
    const double number = parse_number(word, std::is_same_v<T, float>, "a place");
    require(std::isfinite(number), "'{}' was let in as {}", word, number);
    const auto expected = by_cpp_library<T>(word);
    require(!expected || is_same(static_cast<T>(number), *expected),
            "'{}' was read as {}; {} is right", word, number, expected.value_or(0));
    require(is_same(double{static_cast<T>(number)}, number), "'{}' was not rounded: {}", word,
            number);
  });
}

PrimitiveForm form_from(ByteReader& in) {
  PrimitiveForm form;
  form.space = in.below(2) == 0 ? "view" : "clip";
  form.scalar = in.below(2) == 0 ? "float" : "double";
  form.attributes = in.below(kMaxAttributes + 1);
  form.flat = in.below(form.attributes + 1);
  form.provoking = in.below(2) == 0 ? "first" : "last";
  return form;
}

}  // namespace

void clip_text(Bytes bytes) {
  ByteReader in(bytes);
  const auto primitive = static_cast<Primitive>(in.below(4));
  const PrimitiveForm form = form_from(in);
  read_or_refuse([&] {
    const std::vector<TextLine> lines = lines_of("input", text_of(in.rest()));
    for (const TextLine& line : lines) {
      for (const std::string& word : line.words) {
        check_file_number(word);
        check_number<float>(word);
        check_number<double>(word);
      }
    }
    const auto stride = static_cast<std::size_t>(form.attributes) + (form.space == "view" ? 3 : 4);
    const std::size_t needed = vertices_of(primitive);
    for (const TextPrimitive& p : primitives_in(lines, form, primitive)) {
      const std::size_t vertices = p.values.size() / stride;
      require(p.values.size() % stride == 0 && vertices == (needed == 0 ? vertices : needed) &&
                  vertices >= (needed == 0 ? 3 : needed),
              "{}: a {} was made of {} numbers, {} per vertex", p.place, to_string(primitive),
              p.values.size(), stride);
    }
  });
}

void cases(Bytes bytes) {
  read_or_refuse([&] {
    for (const HardCase& c : read_cases("fuzz.cases", text_of(bytes))) {
      require(is_finite(c), "{}: a number of the case is not finite", c.name);
      require(c.expected == exact_outcome(c), "{}: expects what is not so", c.name);
      const std::size_t needed = vertices_of(c.primitive);
      require(needed == 0 ? c.vertices.size() >= 3 : c.vertices.size() == needed,
              "{}: a {} has {} vertices", c.name, to_string(c.primitive), c.vertices.size());
    }
  });
}

}  // namespace clipscope::fuzz

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guests/program_text.hpp"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cstdlib>
#include <iterator>
#include <utility>

#include "experiments/table/hex_float.hpp"
#include "experiments/table/utf8.hpp"

namespace clipscope::experiments {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) + 1 - first);
}

std::vector<std::string> fields_of(std::string_view row) {
  std::vector<std::string> fields;
  while (true) {
    const std::size_t comma = row.find(',');
    fields.emplace_back(trimmed(row.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    row.remove_prefix(comma + 1);
  }
}

std::string headings_of(int attributes, const ProgramForm& form) {
  std::string row = fmt::format("{}{},vertex,x,y,z,inv_w", to_string(form.primitive),
                                form.primitive == Primitive::polygon ? ",part" : "");
  for (int k = 0; k < attributes; ++k) row += fmt::format(",a{}", k);
  return row;
}

// Nothing unless the whole field is a whole number.
std::optional<std::size_t> whole_number(const std::string& field) {
  std::size_t number = 0;
  const char* const end = field.data() + field.size();
  const auto [last, error] = std::from_chars(field.data(), end, number);
  return error == std::errc() && last == end ? std::optional(number) : std::nullopt;
}

// Rounded to the format once; nothing unless the whole field is a number.
std::optional<double> number_of(const std::string& field, const Format& format) {
  if (field.empty()) return std::nullopt;
  char* end = nullptr;
  const double x =
      format.is_float() ? std::strtof(field.c_str(), &end) : std::strtod(field.c_str(), &end);
  return end == field.c_str() + field.size() ? std::optional(x) : std::nullopt;
}

// As a message quotes it: a part of it is enough.
std::string in_quotes(std::string_view text) {
  constexpr std::size_t kMost = 80;
  const bool is_long = text.size() > kMost;
  return fmt::format("'{}{}'", visible_utf8(valid_utf8(text.substr(0, kMost), "")),
                     is_long ? "..." : "");
}

class AnswerReader {
 public:
  AnswerReader(std::size_t count, int attributes, const ProgramForm& form)
      : form_(form),
        headings_(headings_of(attributes, form)),
        labels_(form.primitive == Primitive::polygon ? 3 : 2),
        numbers_(4 + static_cast<std::size_t>(attributes)) {
    answers_.polygons.resize(count);
  }

  WrittenAnswers read(std::string_view csv) {
    for (std::size_t line = 1; !csv.empty() && answers_.wrong.empty(); ++line) {
      const std::size_t end = csv.find('\n');
      read_row(trimmed(csv.substr(0, end)), line);
      csv.remove_prefix(end == std::string_view::npos ? csv.size() : end + 1);
    }
    return std::move(answers_);
  }

 private:
  void read_row(std::string_view row, std::size_t line) {
    if (row.empty() || (line == 1 && row == headings_)) return;
    const std::vector<std::string> fields = fields_of(row);
    const std::optional<std::size_t> primitive = whole_number(fields[0]);
    const std::string place = fmt::format("writes {} in line {}", in_quotes(row), line);
    if (!primitive) {
      answers_.wrong = fmt::format("{}: expected a row of {}", place, headings_);
    } else if (*primitive >= answers_.polygons.size()) {
      answers_.wrong =
          fmt::format("{}: there is no {} {}; it was asked about {}, counted from 0", place,
                      to_string(form_.primitive), *primitive, answers_.polygons.size());
    } else if (WrittenPolygon& polygon = answers_.polygons[*primitive]; polygon.wrong.empty()) {
      const std::string wrong = read_vertex(fields, polygon);
      if (!wrong.empty()) polygon.wrong = fmt::format("{}: {}", place, wrong);
    }
  }

  // What is wrong with it; empty if it was added.
  std::string read_vertex(const std::vector<std::string>& fields, WrittenPolygon& polygon) const {
    if (fields.size() != labels_ + numbers_) {
      return fmt::format("{} columns, expected {}: {}", fields.size(), labels_ + numbers_,
                         headings_);
    }
    if (labels_ == 3 && whole_number(fields[1]) != 0) return "expected part 0";
    const std::size_t next = polygon.numbers.size() / numbers_;
    if (whole_number(fields[labels_ - 1]) != next) {
      return fmt::format("vertex {} is out of order, expected {}", in_quotes(fields[labels_ - 1]),
                         next);
    }
    for (std::size_t i = labels_; i < fields.size(); ++i) {
      const std::optional<double> x = number_of(fields[i], *form_.format);
      if (!x) return fmt::format("{} is not a number", in_quotes(fields[i]));
      polygon.numbers.push_back(*x);
    }
    return "";
  }

  const ProgramForm& form_;
  std::string headings_;
  std::size_t labels_, numbers_;  // columns
  WrittenAnswers answers_;
};

}  // namespace

std::string number_text(double x, const ProgramForm& form) {
  if (form.hex) return hex_float(x);
  return form.format->is_float() ? fmt::format("{}", static_cast<float>(x)) : fmt::format("{}", x);
}

std::string lines_of(const GuestInput& input, const Range& range, const ProgramForm& form) {
  std::string text;
  for (std::size_t p = range.first; p < range.first + range.count; ++p) {
    const std::size_t first = input.first_vertex(p) * input.stride();
    const std::size_t end = input.ends[p] * input.stride();
    for (std::size_t i = first; i < end; ++i) {
      text += number_text(input.numbers[i], form);
      text += i + 1 < end ? ' ' : '\n';
    }
  }
  return text;
}

WrittenAnswers read_answers(std::string_view csv, std::size_t count, int attributes,
                            const ProgramForm& form) {
  return AnswerReader(count, attributes, form).read(csv);
}

}  // namespace clipscope::experiments

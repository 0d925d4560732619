// SPDX-License-Identifier: GPL-3.0-or-later
//
// Primitives as text.
//
// A line holds one primitive: a point, a segment, a triangle, or a polygon of three vertices or
// more. Each vertex is its position (3 numbers in view space, 4 in clip space) and then its K
// attributes; numbers are decimal or C99 hex floats, separated by blanks or commas. '#' starts a
// comment; empty lines are skipped. A number is rounded once, to float for the scalars float and
// counting and to double for the others.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"

namespace clipscope::experiments::commands {

// A line that holds anything: its words.
struct TextLine {
  std::string place;  // "file:line"
  std::vector<std::string> words;
};

// Of a text. Errors: InputError if it is neither ASCII nor UTF-8.
std::vector<TextLine> lines_of(const std::string& source, std::string_view text);
// Of a file, or "-": standard input. Errors: InputError if it can't be read; those of lines_of.
std::vector<TextLine> read_lines(const std::string& path);

// The number, rounded once to float or double. Errors: InputError naming the place.
double parse_number(const std::string& word, bool as_float, const std::string& place);

// What the numbers of a primitive are.
struct PrimitiveForm {
  std::string space = "view";
  std::string scalar = "float";
  int attributes = 0;
  int flat = 0;                     // so many of the last attributes have one value per primitive:
  std::string provoking = "first";  // that of its first or last vertex
};

// Whether its numbers are rounded to float.
bool reads_floats(const PrimitiveForm& form);

struct TextPrimitive {
  std::string place;           // "file:line"
  std::vector<double> values;  // (dimension + K) for each vertex; the scalar holds them exactly
};

// A primitive for each line. Errors: InputError naming file and line, what was found, what was
// expected. Pre-condition: 0 <= flat <= attributes.
std::vector<TextPrimitive> primitives_in(const std::vector<TextLine>& lines,
                                         const PrimitiveForm& form, Primitive primitive);

}  // namespace clipscope::experiments::commands

// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a program reads and writes: lines as `clipscope clip` reads them, CSV as it writes it.
//
// A line in holds one primitive: of each vertex its position, then its attributes, separated by
// blanks. A row out is a vertex: "triangle,vertex,x,y,z,inv_w,a0,..." ("polygon,part,vertex,..."
// with part 0), numbers decimal or hex floats, inf and nan included. The row of headings may be
// left out, primitives may come in any order, the vertices of one are numbered from 0 on.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/contestants/scalars.hpp"
#include "experiments/guests/bisect.hpp"
#include "experiments/guests/input.hpp"

namespace clipscope::experiments {

struct ProgramForm {
  Primitive primitive = Primitive::triangle;
  const Format* format = nullptr;  // float or double
  bool hex = false;  // numbers that the program reads: else decimal, as short as exact
};

// A number that reads back as the same one of the format.
std::string number_text(double x, const ProgramForm& form);

// The primitives of the range, a line each.
std::string lines_of(const GuestInput& input, const Range& range, const ProgramForm& form);

// What a program wrote about one primitive.
struct WrittenPolygon {
  std::vector<double> numbers;  // vertex after vertex, each rounded to the format once
  std::string wrong;            // why it is no answer; empty if it is one
};

struct WrittenAnswers {
  std::vector<WrittenPolygon> polygons;  // one for each primitive
  std::string wrong;                     // a line that belongs to none of them; empty if none does
};

// count: primitives that were asked about; attributes: of each vertex. It never fails.
WrittenAnswers read_answers(std::string_view csv, std::size_t count, int attributes,
                            const ProgramForm& form);

}  // namespace clipscope::experiments

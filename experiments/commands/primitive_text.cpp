// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/commands/primitive_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>

#include "experiments/contestants/scalars.hpp"
#include "experiments/scenes/text_file.hpp"

namespace clipscope::experiments::commands {
namespace {

// What a line must hold, in numbers.
struct LineShape {
  Primitive primitive;
  std::size_t dimension, per_vertex;

  bool fits(std::size_t numbers) const {
    if (primitive != Primitive::polygon) return numbers == vertices_of(primitive) * per_vertex;
    return numbers >= 3 * per_vertex && numbers % per_vertex == 0;
  }
  std::string text(const PrimitiveForm& form) const {
    const std::size_t n = vertices_of(primitive);
    std::string count = std::to_string(n * per_vertex);
    std::string vertices = fmt::format("{} {}", n, n == 1 ? "vertex" : "vertices");
    if (primitive == Primitive::polygon) {
      count = fmt::format("a multiple of {} from {}", per_vertex, 3 * per_vertex);
      vertices = "3 or more vertices";
    }
    return fmt::format("a {} in {} space takes {}: {} of {} coordinates and {} attributes",
                       to_string(primitive), form.space, count, vertices, dimension,
                       form.attributes);
  }
};

// A ring as GeoJSON has it, its last vertex the first one again, is the polygon without that.
void open_ring(std::vector<double>& values, std::size_t per_vertex) {
  const auto size = static_cast<std::ptrdiff_t>(per_vertex);
  const bool is_ring = values.size() > 3 * per_vertex &&
                       std::equal(values.begin(), values.begin() + size, values.end() - size);
  if (is_ring) values.resize(values.size() - per_vertex);
}

// Gives all vertices the last `flat` numbers of the provoking one.
void make_flat(std::vector<double>& values, std::size_t per_vertex, const PrimitiveForm& form) {
  const auto flat = static_cast<std::ptrdiff_t>(form.flat);
  const auto stride = static_cast<std::ptrdiff_t>(per_vertex);
  const auto size = static_cast<std::ptrdiff_t>(values.size());
  const std::ptrdiff_t end = form.provoking == "last" ? size : stride;
  for (std::ptrdiff_t v = stride; v <= size; v += stride) {
    std::copy_n(values.begin() + end - flat, flat, values.begin() + v - flat);
  }
}

// All that is left of a stream. Errors: InputError.
std::string read_all(std::istream& in, const std::string& name) {
  std::string text;
  std::array<char, 65536> block;
  while (in.read(block.data(), block.size()) || in.gcount() > 0) {
    text.append(block.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) throw InputError(fmt::format("{}: can't be read", name));
  return text;
}

}  // namespace

std::vector<TextLine> lines_of(const std::string& source, std::string_view text) {
  std::vector<TextLine> lines;
  TextFile file(source, text, {.separator = ',', .comment = '#'});
  while (file.next_words()) {
    lines.push_back({file.place(), {file.words().begin(), file.words().end()}});
  }
  return lines;
}

std::vector<TextLine> read_lines(const std::string& path) {
  if (path == "-") return lines_of("standard input", read_all(std::cin, "standard input"));
  errno = 0;
  std::ifstream file(path);
  if (!file) throw InputError(fmt::format("{}: can't be opened: {}", path, std::strerror(errno)));
  return lines_of(path, read_all(file, path));
}

double parse_number(const std::string& word, bool as_float, const std::string& place) {
  char* end = nullptr;
  const double value = as_float ? std::strtof(word.c_str(), &end) : std::strtod(word.c_str(), &end);
  if (end != word.c_str() + word.size()) {
    refuse(place,
           "'{}' is not a number; expected a decimal such as -0.25 or a hex float such as -0x1p-2",
           word);
  }
  if (std::isfinite(value)) return value;
  refuse(place, "'{}' is not finite{}; expected a finite number", word,
         as_float ? " as a float" : "");
}

bool reads_floats(const PrimitiveForm& form) {
  return form.scalar == kFormat<float>.name || form.scalar == kFormat<Counted>.name;
}

std::vector<TextPrimitive> primitives_in(const std::vector<TextLine>& lines,
                                         const PrimitiveForm& form, Primitive primitive) {
  const std::size_t dimension = form.space == "view" ? 3 : 4;
  const LineShape shape{primitive, dimension,
                        dimension + static_cast<std::size_t>(form.attributes)};
  std::vector<TextPrimitive> primitives;
  for (const TextLine& line : lines) {
    if (!shape.fits(line.words.size())) {
      refuse(line.place, "found {} numbers; {}", line.words.size(), shape.text(form));
    }
    std::vector<double>& values = primitives.emplace_back(TextPrimitive{line.place, {}}).values;
    for (const std::string& word : line.words) {
      values.push_back(parse_number(word, reads_floats(form), line.place));
    }
    if (primitive == Primitive::polygon) open_ring(values, shape.per_vertex);
    make_flat(values, shape.per_vertex, form);
  }
  return primitives;
}

}  // namespace clipscope::experiments::commands

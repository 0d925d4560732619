// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/commands/primitive_text.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>

#include "experiments/commands/number_list.hpp"
#include "experiments/errors.hpp"
#include "spaces/clippers.hpp"
#include "spaces/homogeneous/polygon.hpp"
#include "spaces/vertex.hpp"

namespace clipscope::experiments {
namespace {

bool reads_floats(const PrimitiveTextOptions& options) {
  return options.scalar == ScalarTraits<float>::name ||
         options.scalar == ScalarTraits<Counted>::name;
}

bool is_separator(char c) { return c == ',' || std::isspace(static_cast<unsigned char>(c)) != 0; }

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : line.substr(0, line.find('#'))) {
    if (!is_separator(c)) {
      word += c;
    } else if (!word.empty()) {
      words.push_back(std::move(word));
      word.clear();
    }
  }
  if (!word.empty()) words.push_back(std::move(word));
  return words;
}

// The number rounded once to the format that is read. Errors: InputError.
double parse_number(const std::string& word, bool as_float, const std::string& place) {
  char* end = nullptr;
  const double value = as_float ? std::strtof(word.c_str(), &end) : std::strtod(word.c_str(), &end);
  if (end != word.c_str() + word.size()) {
    throw InputError(
        fmt::format("{}: '{}' is not a number; expected a decimal such as -0.25 or a hex "
                    "float such as -0x1p-2",
                    place, word));
  }
  if (!std::isfinite(value)) {
    throw InputError(fmt::format("{}: '{}' is not finite{}; expected a finite number", place, word,
                                 as_float ? " as a float" : ""));
  }
  return value;
}

// Numbers in a line: of a polygon a multiple of `per_vertex` with at least three vertices.
bool is_complete(std::size_t numbers, Primitive primitive, std::size_t per_vertex) {
  if (primitive == Primitive::polygon) {
    return numbers >= 3 * per_vertex && numbers % per_vertex == 0;
  }
  return numbers == vertices_of(primitive) * per_vertex;
}

std::string expected_numbers(const PrimitiveTextOptions& options, Primitive primitive,
                             std::size_t dimension, std::size_t per_vertex) {
  const std::size_t n = vertices_of(primitive);
  const std::string vertices = primitive == Primitive::polygon
                                   ? "3 or more vertices"
                                   : fmt::format("{} {}", n, n == 1 ? "vertex" : "vertices");
  const std::string count =
      primitive == Primitive::polygon
          ? fmt::format("a multiple of {} from {}", per_vertex, 3 * per_vertex)
          : fmt::format("{}", n * per_vertex);
  return fmt::format("a {} in {} space takes {}: {} of {} coordinates and {} attributes",
                     to_string(primitive), options.space, count, vertices, dimension,
                     options.attributes);
}

std::string source_name(const PrimitiveTextOptions& options) {
  return options.file == "-" ? "standard input" : options.file;
}

std::vector<TextPrimitive> read_stream(std::istream& in, const PrimitiveTextOptions& options,
                                       Primitive primitive) {
  const std::size_t dimension = options.space == "view" ? 3 : 4;
  const std::size_t per_vertex = dimension + static_cast<std::size_t>(options.attributes);
  std::vector<TextPrimitive> primitives;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    const std::string place = fmt::format("{}:{}", source_name(options), ++number);
    const std::vector<std::string> words = split(line);
    if (words.empty()) continue;
    if (!is_complete(words.size(), primitive, per_vertex)) {
      throw InputError(fmt::format("{}: found {} numbers; {}", place, words.size(),
                                   expected_numbers(options, primitive, dimension, per_vertex)));
    }
    TextPrimitive& read = primitives.emplace_back(TextPrimitive{number, {}});
    for (const std::string& word : words) {
      read.values.push_back(parse_number(word, reads_floats(options), place));
    }
  }
  if (in.bad()) throw InputError(fmt::format("{}: can't be read", source_name(options)));
  return primitives;
}

// A far plane given as `inf`.
void set_far(Frustum<double>& f, double far) {
  f.infinite_far = std::isinf(far);
  f.far = f.infinite_far ? 0.0 : far;
}

Frustum<double> described_frustum(const PrimitiveTextOptions& options) {
  Frustum<double> f;
  f.depth = depth_range(options);
  if (!options.perspective.empty()) {
    const std::vector<double>& p = options.perspective;
    if (!(p[0] > 0 && p[0] < 180 && p[1] > 0)) {
      throw UsageError(
          fmt::format("--perspective: FOVY {} must lie in (0, 180) degrees and ASPECT {} "
                      "must be positive",
                      p[0], p[1]));
    }
    f.top = p[2] * std::tan(p[0] * (M_PI / 360.0));
    f.right = p[1] * f.top;
    f.bottom = -f.top;
    f.left = -f.right;
    f.near = p[2];
    set_far(f, p[3]);
    return f;
  }
  const bool parallel = options.frustum.empty();
  const std::vector<double>& v = parallel ? options.ortho : options.frustum;
  f.kind = parallel ? ProjectionKind::parallel : ProjectionKind::perspective;
  f.left = v[0];
  f.right = v[1];
  f.bottom = v[2];
  f.top = v[3];
  f.near = v[4];
  set_far(f, v[5]);
  return f;
}

}  // namespace

void add_primitive_text_options(CLI::App& command, PrimitiveTextOptions& options) {
  command
      .add_option("--space", options.space,
                  "Space of the input: view (x y z) or clip (x y z w) [view]")
      ->check(CLI::IsMember({"view", "clip"}));
  command.add_option("--scalar", options.scalar,
                     "Scalar to compute in (see `clipscope list scalars`) [float]");
  command.add_option("--attributes", options.attributes, "Attributes per vertex [0]")
      ->type_name("K")
      ->check(CLI::Range(0, kMaxAttributes));
  const auto numbers = [&](const char* name, std::vector<double>& target, std::size_t count,
                           const char* type, const char* help) {
    add_number_list(
        command, name, count, type,
        [&target](const std::vector<double>& values) { target = values; }, help);
  };
  numbers("--perspective", options.perspective, 4, "FOVY,ASPECT,NEAR,FAR",
          "Perspective projection, FOVY in degrees; FAR may be inf");
  numbers("--frustum", options.frustum, 6, "L,R,B,T,N,F",
          "Perspective projection, sides measured on the near plane; F may be inf");
  numbers("--ortho", options.ortho, 6, "L,R,B,T,N,F", "Orthographic projection");
  command
      .add_option("--depth", options.depth,
                  "Depth convention: gl [-1, 1], zero_to_one [0, 1] or reversed [1, 0] [gl]")
      ->check(CLI::IsMember({"gl", "zero_to_one", "reversed"}));
  command.add_option("file", options.file, "Primitives, one per line [standard input]")
      ->type_name("FILE");
}

DepthRange depth_range(const PrimitiveTextOptions& options) {
  if (options.depth == "zero_to_one") return DepthRange::zero_to_one;
  if (options.depth == "reversed") return DepthRange::reversed;
  return DepthRange::minus_one_to_one;
}

Frustum<double> frustum_of(const PrimitiveTextOptions& options) {
  const int given =
      !options.perspective.empty() + !options.frustum.empty() + !options.ortho.empty();
  if (options.space == "clip") {
    if (given != 0) {
      throw UsageError(
          "--perspective, --frustum and --ortho go with --space view: clip-space "
          "coordinates are projected already");
    }
    Frustum<double> f;
    f.depth = depth_range(options);
    return f;
  }
  if (given != 1) {
    throw UsageError(
        fmt::format("--space view takes one of --perspective, --frustum and --ortho, {} "
                    "are given",
                    given));
  }
  Frustum<double> f = described_frustum(options);
  if (reads_floats(options)) f = frustum_cast<double>(frustum_cast<float>(f));
  if (!is_valid(f) || !std::isfinite(f.left + f.right + f.bottom + f.top + f.near + f.far)) {
    throw UsageError(fmt::format(
        "the frustum left={} right={} bottom={} top={} near={} far={} encloses no volume; expected "
        "left < right, bottom < top, near < far, and 0 < near for perspective",
        f.left, f.right, f.bottom, f.top, f.near, f.infinite_far ? HUGE_VAL : f.far));
  }
  return f;
}

std::vector<TextPrimitive> read_primitives(const PrimitiveTextOptions& options,
                                           Primitive primitive) {
  if (options.file == "-") return read_stream(std::cin, options, primitive);
  errno = 0;
  std::ifstream file(options.file);
  if (!file) {
    throw InputError(fmt::format("{}: can't be opened: {}", options.file, std::strerror(errno)));
  }
  return read_stream(file, options, primitive);
}

std::string place_of(const PrimitiveTextOptions& options, const TextPrimitive& primitive) {
  return fmt::format("{}:{}", source_name(options), primitive.line);
}

std::string_view default_clipper(Primitive primitive) {
  switch (primitive) {
    case Primitive::point: return PointPop::name;
    case Primitive::segment: return HomogeneousLiangBarsky::name;
    case Primitive::triangle: return HomogeneousSutherlandHodgman::name;
    case Primitive::polygon: break;
  }
  return HomogeneousPolygonClipper<float, kRunTime>::name;
}

}  // namespace clipscope::experiments

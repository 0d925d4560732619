// SPDX-License-Identifier: GPL-3.0-or-later
//
// Primitives as text, and the options that say what they mean.
//
// One primitive per line: a point, a segment, a triangle, or a polygon of three vertices or more. Each
// vertex is its position (3 numbers in view space, 4 in clip space) and then its K attributes; numbers
// are decimal or C99 hex floats, separated by blanks or commas. '#' starts a comment; empty lines are
// skipped. A number is rounded once, to float for the scalars float and counting and to double for the
// others.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/contestants/scalars.hpp"
#include "spaces/projection.hpp"

namespace CLI {
class App;
}

namespace clipscope::experiments {

struct PrimitiveTextOptions {
  std::string space = "view";
  std::string scalar = "float";
  int attributes = 0;
  std::vector<double> perspective, frustum, ortho;  // empty: not given
  std::string depth = "gl";
  std::string file = "-";  // "-": standard input
};

void add_primitive_text_options(CLI::App& command, PrimitiveTextOptions& options);

DepthRange depth_range(const PrimitiveTextOptions& options);

// The frustum that the options describe, its numbers rounded to float if the scalar is a float.
// Errors: UsageError unless exactly one of --perspective, --frustum and --ortho is given for view space
// and none for clip space, or if it encloses no volume.
Frustum<double> frustum_of(const PrimitiveTextOptions& options);

// A primitive with the number of the line that it came from. (dimension + K) values for each vertex, as
// doubles that the scalar holds exactly.
struct TextPrimitive {
  std::size_t line;
  std::vector<double> values;
};

// All primitives of the file. Errors: InputError naming file and line, what was found, what was expected.
std::vector<TextPrimitive> read_primitives(const PrimitiveTextOptions& options,
                                           Primitive primitive);

// "file:line" of the primitive.
std::string place_of(const PrimitiveTextOptions& options, const TextPrimitive& primitive);

template <class T, Space S>
std::vector<Vertex<S, T, kRunTime>> vertices_of(const TextPrimitive& text, int attributes) {
  constexpr int kDimension = Vertex<S, T, kRunTime>::kDimension;
  std::vector<Vertex<S, T, kRunTime>> vertices(text.values.size() /
                                               static_cast<std::size_t>(kDimension + attributes));
  std::size_t next = 0;
  for (Vertex<S, T, kRunTime>& v : vertices) {
    for (int i = 0; i < kDimension; ++i) v.position[i] = scalar_from<T>(text.values[next++]);
    v.attributes.resize(attributes);
    for (int k = 0; k < attributes; ++k) v.attributes[k] = scalar_from<T>(text.values[next++]);
  }
  return vertices;
}

// Pre-condition: N vertices.
template <Space S, class T, std::size_t N>
Simplex<S, T, kRunTime, N> simplex_of(const std::vector<Vertex<S, T, kRunTime>>& vertices) {
  Simplex<S, T, kRunTime, N> simplex;
  std::copy_n(vertices.begin(), N, simplex.begin());
  return simplex;
}

template <class T, Space S>
Triangle<S, T, kRunTime> triangle_of(const TextPrimitive& text, int attributes) {
  return simplex_of<S, T, 3>(vertices_of<T, S>(text, attributes));
}

// The clipper that is taken where none is named.
std::string_view default_clipper(Primitive primitive);

}  // namespace clipscope::experiments

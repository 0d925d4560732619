// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles as text, and the options that say what they mean.
//
// One triangle per line: three vertices, each its position (3 numbers in view space, 4 in clip space)
// and then its K attributes; numbers are decimal or C99 hex floats, separated by blanks or commas. '#'
// starts a comment; empty lines are skipped. A number is rounded once, to float for the scalars float
// and counting and to double for the others.
#pragma once

#include <CLI/CLI.hpp>
#include <istream>
#include <string>
#include <vector>

#include "experiments/contestants/scalars.hpp"
#include "spaces/projection.hpp"

namespace clipscope::experiments {

struct TriangleTextOptions {
  std::string space = "view";
  std::string scalar = "float";
  int attributes = 0;
  std::vector<double> perspective, frustum, ortho;  // empty: not given
  std::string depth = "gl";
  std::string file = "-";  // "-": standard input
};

void add_triangle_text_options(CLI::App& command, TriangleTextOptions& options);

DepthRange depth_range(const TriangleTextOptions& options);

// The frustum that the options describe, its numbers rounded to float if the scalar is a float.
// Errors: UsageError unless exactly one of --perspective, --frustum and --ortho is given for view space
// and none for clip space, or if it encloses no volume.
Frustum<double> frustum_of(const TriangleTextOptions& options);

// A triangle with the number of the line that it came from. 3 * (dimension + K) values, as doubles that
// the scalar holds exactly.
struct TextTriangle {
  std::size_t line;
  std::vector<double> values;
};

// All triangles of the file. Errors: InputError naming file and line, what was found, what was expected.
std::vector<TextTriangle> read_triangles(const TriangleTextOptions& options);

template <class T, Space S>
Triangle<S, T, kRunTime> triangle_of(const TextTriangle& text, int attributes) {
  constexpr int kDimension = Vertex<S, T, kRunTime>::kDimension;
  Triangle<S, T, kRunTime> triangle;
  std::size_t next = 0;
  for (Vertex<S, T, kRunTime>& v : triangle) {
    for (int i = 0; i < kDimension; ++i) v.position[i] = scalar_from<T>(text.values[next++]);
    v.attributes.resize(attributes);
    for (int k = 0; k < attributes; ++k) v.attributes[k] = scalar_from<T>(text.values[next++]);
  }
  return triangle;
}

}  // namespace clipscope::experiments

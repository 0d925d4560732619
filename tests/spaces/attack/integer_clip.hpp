// SPDX-License-Identifier: GPL-3.0-or-later
//
// The exact part of a triangle inside a volume, by integers, and each of its numbers as the nearest
// float: what a correctly rounded clipper has to answer.
//
// It is the definition, spelled out, and not an algorithm of anybody's: floats are integers times
// 2^-149; the part inside is the set of barycentric lambda >= 0 with lambda . d >= 0 for the three
// distances d to each plane; its corners are the meetings of any two of these lines that no other
// line excludes. Nothing is filtered, and nothing is reused from one triangle to the next. It
// shares no code with spaces/ or reference/.
//
// The contract (spaces/README.md), as far as bits are concerned:
//   - fewer than three corners are nothing, and corners with w = 0 are left out;
//   - 0 is +0, and what rounds to 0 from below is -0;
//   - of the stage's polygon, vertices of the triangle come out with the bits that they came with;
//   - in NDC, where z rounds to infinity nothing comes out;
//   - nothing comes out where all corners lie in a side that does not own its points.
// A polygon begins at any vertex.
#pragma once

#include <cstddef>
#include <vector>

#include "tests/spaces/attack/facts.hpp"
#include "tests/spaces/attack/input.hpp"
#include "tests/spaces/attack/integer_rounding.hpp"

namespace clipscope::attack {

// Numbers at the three vertices of a triangle, or of a point, in any scale.
using Weights = std::array<Integer, 3>;
Integer dot(const Weights& a, const Weights& b);

// A corner of the part inside.
struct Corner {
  Weights lambda;  // >= 0, not all 0
  int own = -1;    // the vertex of the triangle that it is, or -1
  int planes = 0;  // how many planes pass through it by construction
  bool on_clip_distance = false;
};

// Those with w > 0, in the order of the triangle; none if there are fewer than three.
// Pre-condition: all floats are finite.
std::vector<Corner> corners(const Batch& batch, std::size_t triangle, Facts& facts);

// What a polygon's float is: lambda . numerator / lambda . denominator.
struct Channel {
  Weights numerator, denominator;
};
// x, y, z, 1/w in NDC, or x, y, z, w in clip space, then the attributes.
std::vector<Channel> ndc_channels(const Batch& batch, std::size_t triangle);
std::vector<Channel> clip_channels(const Batch& batch, std::size_t triangle);

// Polygons: 4 + attributes floats for each vertex. The stage's is that of a clip-space triangle.
struct Answer {
  std::vector<float> ndc, stage;
};
Answer exact_answer(const Batch& batch, std::size_t triangle, Facts& facts);

}  // namespace clipscope::attack

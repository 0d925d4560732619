// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles that cross exactly so many planes of the volume, with attributes for every
// interpolation mode.
#pragma once

#include <cstdint>
#include <vector>

#include "experiments/judge/compare.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments {

// What the four attributes of a triangle are.
enum AttributeRole {
  kSmooth,     // the value a in [0, 1], another one at each vertex
  kTimesW,     // a * w: carries an attribute without perspective correction through any clipper
  kProvoking,  // the first vertex's flat value, at all vertices
  kOwnFlat,    // the vertex's own flat value in [0, 1]
};

// Every coordinate and attribute is a float but kTimesW, which is the exact product of two.
using AttributeTriangle = ViewTriangle<double, 4>;

// near 1, far 100, 90 degrees wide, 16:9.
Frustum<float> attribute_frustum();

// Planes that hold an edge of the polygon, depth in [-1, 1]. Exact.
Outcode planes_with_edge(const reference::ExactPolygon& polygon);

// Triangles with w > 0 at all vertices. Some vertex is outside of `planes` planes, no more, and
// each of these holds an edge of the visible part, both decided exactly: a chain of cuts makes that
// many cuts, and each of them can be seen. The same bits for the same seed.
// Pre-condition: 1 <= planes <= 6.
std::vector<AttributeTriangle> crossing_triangles(int planes, std::size_t count,
                                                  std::uint64_t seed);

}  // namespace clipscope::experiments

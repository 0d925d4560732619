// SPDX-License-Identifier: GPL-3.0-or-later
//
// A clipper's polygon against the exact one.
//
// Vertices are matched in order, at the rotation that brings them closest (those of a segment in its
// own order); repeated vertices count once. Errors are differences to exact rationals, rounded to double only at the end (relative error
// below 2^-20).
#pragma once

#include <span>
#include <vector>

#include "experiments/contestants/scalars.hpp"
#include "experiments/measure/outcome.hpp"
#include "reference/exact_clip.hpp"
#include "spaces/vertex.hpp"

namespace clipscope::experiments {

// Coordinate i of an exact vertex: x, y, z, 1/w, then the attributes.
const reference::Fraction& coordinate(const reference::ExactVertex& v, int i);

// The exact answer for one primitive, with each coordinate also as the nearest double or next to it:
// x, y, z, 1/w, then the attributes.
struct TruthPolygon {
  reference::ExactPolygon exact;
  std::vector<std::vector<double>> approximation;
  std::size_t needed = 3;  // vertices that enclose anything: 3, of a segment 2, of a point 1

  bool is_visible() const { return exact.vertices.size() >= needed; }
};

TruthPolygon truth_polygon(const reference::Truth& truth, const reference::InputTriangle& triangle);
// A point, a segment, a triangle or a convex polygon. Pre-conditions: those of reference::clip.
TruthPolygon truth_polygon(const reference::Truth& truth,
                           std::span<const reference::InputVertex> vertices, int attribute_count);

// Errors of one primitive: the largest over its vertices. Meaningless (0) unless the vertices match,
// that is for outcomes up to `visible`.
struct Comparison {
  Outcome outcome = Outcome::exact;
  double position_px = 0;   // in x and y, on a screen of 3840 x 2160
  double position_ulp = 0;  // over x, y, z and 1/w, in the scalar's own ulp at the exact value
  double attribute = 0;     // absolute
  bool visible = false;     // in the exact answer or in this one
};

template <class T, int K>
Comparison compare(std::span<const NdcVertex<T, K>> polygon, const TruthPolygon& truth);

}  // namespace clipscope::experiments

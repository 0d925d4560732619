// SPDX-License-Identifier: GPL-3.0-or-later
//
// A clipper's polygon against the exact one.
//
// Vertices are matched in order, at the rotation that brings them closest (those of a segment in
// its own order); repeated vertices count once, unless the answer has every vertex of the exact
// polygon, each within an ulp: small polygons have vertices that fall together when they are
// rounded. Errors are differences to exact rationals, rounded to double only at the end (relative
// error below 2^-20).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "experiments/contestants/answers.hpp"
#include "experiments/contestants/batch.hpp"
#include "experiments/judge/outcome.hpp"
#include "reference/exact_clip.hpp"

namespace clipscope::experiments {

// Coordinate i of an exact vertex: x, y, z, 1/w, then the attributes.
const reference::Fraction& coordinate(const reference::ExactVertex& v, int i);

// The exact answer for one primitive, with each coordinate also as the nearest double or next to
// it: x, y, z, 1/w, then the attributes.
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
// One for each primitive of a batch, in parallel.
std::vector<TruthPolygon> truth_polygons(const reference::Truth& truth, const Batch& batch);

// Errors of one primitive: the largest over its vertices. Meaningless (0) unless the vertices
// match, that is for outcomes up to `visible`.
struct Comparison {
  Outcome outcome = Outcome::exact;
  double position_px = 0;   // in x and y, on a screen of 3840 x 2160
  double position_ulp = 0;  // over x, y, z and 1/w, in the scalar's own ulp at the exact value
  double attribute = 0;     // absolute
  bool visible = false;     // in the exact answer or in this one
};

Comparison compare(const PolygonView& polygon, const TruthPolygon& truth);

// The answer's vertices in the order of the exact ones, vertex i for exact vertex i; nothing where
// something else than these was drawn, or nothing is visible. Pre-condition: all numbers are
// usable, as they are for outcomes up to `visible`.
std::optional<std::vector<VertexView>> matched_vertices(const PolygonView& polygon,
                                                        const TruthPolygon& truth);

// One for each polygon of the answers, in parallel. Pre-condition: as many truths.
std::vector<Comparison> compare(const Answers& answers, std::span<const TruthPolygon> truths);

// A number of any scalar as the nearest float: what a renderer keeps of an answer. Ties to even.
// NaN stays NaN; what overflows becomes infinite.
//
// Rounding by way of a double would round twice: a value just beside the middle between two floats
// could become that middle first. So the double picks the candidates, and the middle next to it is
// compared with the value itself, exactly.
float nearest_float(const Number& x, const Format& format);

}  // namespace clipscope::experiments

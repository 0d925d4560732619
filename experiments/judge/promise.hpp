// SPDX-License-Identifier: GPL-3.0-or-later
//
// Does a clipper's polygon keep the clipper's promise (spaces/clipper.hpp)?
//
// Everything is measured in clip space, attributes as further coordinates, scaled so that they have
// the same unit (u M + eta with their own M and eta): a polygon vertex (x, y, z, 1/w) is the point
// (x, y, z, 1) w. With tolerance = ulps * (u M + eta) * amplification the promise holds if
//   contained  no vertex is farther than the tolerance outside a plane,
//   faithful   no vertex is farther than the tolerance from the input primitive,
//   covers     no vertex of the exact polygon in the volume made smaller by the tolerance is
//              farther than the tolerance from the clipper's polygon.
// Whoever promises correct rounding must have all bits right, on every triangle (`misrounded`). A
// segment is a triangle with its second vertex twice.
// Distances are computed in double-double for float and double, in quad-double for double-double
// (error far below any tolerance), in exact rationals for exact arithmetic unless its polygon is
// the exact one, number by number. Point to triangle: Ericson, "Real-Time Collision Detection",
// 2005, section 5.1.5, which uses dot products alone and so holds in any dimension.
#pragma once

#include <span>
#include <string>

#include "experiments/contestants/answers.hpp"
#include "experiments/contestants/contestant.hpp"
#include "experiments/judge/promise_setting.hpp"
#include "reference/exact_clip.hpp"
#include "spaces/clipper.hpp"

namespace clipscope::experiments {

// outside_domain also where the numbers leave the format (intermediate results overflow, or 1/w
// does and the answer is no point of clip space, or what a frustum's matrix and planes are made of
// over- or underflows), and where the visible part comes so near to the
// eye that its w is within the tolerance of 0: no bound in clip space says anything about NDC
// there.
enum class PromiseVerdict { kept, broken, outside_domain };

struct PromiseCheck {
  // What is too far off of one kind: the first found, and the farthest in tolerances.
  struct Breach {
    std::string reason = "";  // empty: nothing
    double excess = 0;
  };

  PromiseVerdict verdict = PromiseVerdict::kept;
  // Backward error in units of u * M * amplification, over all distances that the promise bounds;
  // for exact arithmetic 0 or infinity.
  double ulps = 0;
  std::string reason = "";  // when broken: what was found and what was promised
  // Drawn outside of volume or triangle; visible and not drawn, or of what is kept whole moved.
  // Both empty where it is broken for another reason.
  Breach contained = {}, covers = {};
};

// Whether both promises ask the same of an answer's distances and of its rounding.
bool is_same_bound(const Promise& a, const Promise& b);

// What a promise is checked against: the volume in exact numbers, and the same volume in doubles
// for magnitudes. For view-space input give the frustum, for clip-space input the volume alone, or
// a batch, which says what its primitives are clipped against.
//
// Where a batch has a matrix, clippers are given clip coordinates that were rounded on their way.
// A product and three sums add 4 u M to the backward error of any of them (Higham, lemma 3.1); what
// holds to the bit of the coordinates given holds of these, not of the exact ones, so that nobody
// is held to correct rounding there.
class PromiseChecker {
 public:
  explicit PromiseChecker(const Batch& batch);
  explicit PromiseChecker(const Frustum<double>& frustum);
  PromiseChecker(const Frustum<double>& frustum, const ClipVolume& volume);
  explicit PromiseChecker(const ClipVolume& volume);

  // Where there is no answer every promise is broken; who promises no distance (no_promise) keeps
  // it. vertices: two of a segment or three of a triangle. Pre-condition: they are finite; for a
  // segment the promise's domain is not all_or_nothing.
  PromiseCheck check(const Promise& promise, std::span<const reference::InputVertex> vertices,
                     int attribute_count, const PolygonView& polygon) const;
  PromiseCheck check(const Promise& promise, const reference::InputTriangle& triangle,
                     const PolygonView& polygon) const {
    return check(promise, triangle.vertices, triangle.attribute_count, polygon);
  }

  const reference::Truth& truth() const { return truth_; }

 private:
  PromiseSetting setting(const Promise& promise, std::span<const reference::InputVertex> vertices,
                         int attribute_count, const Format& format) const;
  bool is_spoken_of(const Promise& promise, const PromiseSetting& setting,
                    const PolygonView& polygon) const;
  double coordinate_magnitude(const reference::InputVertex& vertex) const;
  double largest_intermediate(const reference::InputVertex& vertex) const;

  PromiseChecker(reference::Truth truth, const MatrixRows<double>& rows, const ClipVolume& volume);

  reference::Truth truth_;
  MatrixRows<double> rows_;  // from the input's space to clip space
  ClipVolume volume_;
  FrustumRange range_;
  double longest_ = 0;  // number of a frustum, in whose planes view-space clippers cut
  bool by_matrix_ = false;
};

// Is a polygon of floats the exact one, rounded once to nearest, ties to even, bit for bit?

// What differs; empty if nothing does. The exact answer is nothing where a z rounds to infinity.
// Vertices are compared in order, from the first on; further ones must have the place of one of
// them, and if there are fewer than three, which have no area, nothing is an answer as well. 0 is
// +0.
// Pre-condition: the triangle is finite.
std::string misrounded(const reference::Truth& truth,
                       std::span<const reference::InputVertex> vertices, int attribute_count,
                       const PolygonView& polygon);
// The same whichever vertex is first, and 0 may be -0. The difference named is that of the
// reference's order.
std::string misrounded_in_any_order(const reference::ExactPolygon& exact,
                                    const PolygonView& polygon);

}  // namespace clipscope::experiments

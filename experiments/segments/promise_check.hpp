// SPDX-License-Identifier: GPL-3.0-or-later
//
// Does a line clipper's answer keep the clipper's promise (spaces/clipper.hpp)?
//
// As for triangles (measure/promise.hpp) everything is measured in clip space, attributes as further
// coordinates, scaled so that the largest is as large as M. With tolerance = ulps * u * M *
// amplification the promise holds if
//   contained  no vertex of the answer is farther than the tolerance outside a plane,
//   faithful   no vertex is farther than the tolerance from the input segment,
//   covers     both ends of what is visible in the volume made smaller by the tolerance are no farther
//              than the tolerance from the answer.
// Distances are computed in double-double for float and double, with an error of some 2^-100 M, far
// below any tolerance, and in exact rationals for the others.
// Outside the promise's domain are also segments whose visible part has w within twice the tolerance of 0.
#pragma once

#include <span>

#include "experiments/measure/promise.hpp"

namespace clipscope::experiments {

// Of view-space segments. Pre-condition of `check`: both ends are finite, and the answer is of a
// method whose promise has another domain than all_or_nothing.
class SegmentPromiseChecker {
 public:
  explicit SegmentPromiseChecker(const Frustum<double>& frustum);

  // answer: none or two vertices; another number of them breaks any promise.
  template <class T, int K>
  PromiseCheck check(const Promise& promise, std::span<const reference::InputVertex> ends,
                     int attribute_count, std::span<const NdcVertex<T, K>> answer) const;

 private:
  double magnitude(const reference::InputVertex& end) const;

  reference::Truth truth_;
  Projection<double> projection_;
};

}  // namespace clipscope::experiments

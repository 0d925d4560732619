// SPDX-License-Identifier: GPL-3.0-or-later
//
// Does a clipper's polygon keep the clipper's promise (spaces/clipper.hpp)?
//
// Everything is measured in clip space, attributes as further coordinates (scaled so that the
// largest is as large as M): a polygon vertex (x, y, z, 1/w) is the point (x, y, z, 1) w. With
// tolerance = ulps * (u * M + the smallest positive number) * amplification the promise holds if
//   contained  no vertex is farther than the tolerance outside a plane,
//   faithful   no vertex is farther than the tolerance from the input triangle,
//   covers     no vertex of the exact polygon in the volume made smaller by the tolerance is farther
//              than the tolerance from the clipper's polygon.
// Whoever promises correct rounding must have all bits right, on every triangle (rounding_promise.hpp).
// Distances are computed in double-double for float and double (error far below any tolerance) and in
// exact rationals for the others. Point to triangle: Ericson, "Real-Time Collision Detection", 2005,
// section 5.1.5, which uses dot products alone and so holds in any dimension.
#pragma once

#include <span>
#include <string>

#include "experiments/contestants/scalars.hpp"
#include "reference/exact_clip.hpp"
#include "spaces/clipper.hpp"

namespace clipscope::experiments {

// outside_domain also where the numbers leave the format (intermediate results overflow, or 1/w does and
// the answer is no point of clip space), and where the visible part comes so near to the eye that its w is
// within the tolerance of 0: no bound in clip space says anything about NDC there.
enum class PromiseVerdict { kept, broken, outside_domain };

struct PromiseCheck {
  PromiseVerdict verdict = PromiseVerdict::kept;
  // Backward error in units of u * M * amplification, over all distances that the promise bounds;
  // for exact arithmetic 0 or infinity.
  double ulps = 0;
  std::string reason;  // when broken: what was found and what was promised
};

// What a promise is checked against: the volume in exact numbers, and the same volume in doubles for
// magnitudes. For view-space input give the frustum, for clip-space input the volume alone.
class PromiseChecker {
 public:
  explicit PromiseChecker(const Frustum<double>& frustum);
  PromiseChecker(const Frustum<double>& frustum, const ClipVolume& volume);
  explicit PromiseChecker(const ClipVolume& volume);

  template <class T, int K>
  PromiseCheck check(const Promise& promise, const reference::InputTriangle& triangle,
                     std::span<const NdcVertex<T, K>> polygon) const;

  const reference::Truth& truth() const { return truth_; }

  struct Setting;

 private:
  template <class T, int K>
  bool is_spoken_of(const Promise& promise, const reference::InputTriangle& triangle,
                    const Setting& setting, std::span<const NdcVertex<T, K>> polygon) const;
  template <class N, class T, int K>
  PromiseCheck check_distances(const Promise& promise, const reference::InputTriangle& triangle,
                               const Setting& setting,
                               std::span<const NdcVertex<T, K>> polygon) const;
  double coordinate_magnitude(const reference::InputVertex& vertex) const;
  double largest_intermediate(const reference::InputVertex& vertex) const;

  reference::Truth truth_;
  Projection<double> projection_;
  ClipVolume volume_;
  bool view_input_;
};

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a polygon reaches out of the volume that it was clipped to, to the bit.
#pragma once

#include "experiments/contestants/answers.hpp"
#include "spaces/volume.hpp"

namespace clipscope::experiments {

// Whether z is bounded from below and from above: a plane that is clamped does not bound it.
struct DepthBounds {
  bool low, high;

  explicit DepthBounds(const ClipVolume& volume);
};

// The largest distance in NDC by which an x, a y or a z lies beyond its bound; 0 if all are within
// the volume or on it. Computed exactly and rounded to nearest, so that it is 0 only then. Infinite
// where one of them is NaN or infinite. Clip distances are not looked at.
double overshoot(const ClipVolume& volume, const PolygonView& polygon);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a camera sees, as people have it: an angle of view, a frustum, or the intrinsics of a
// calibrated camera; as a frustum of floats, which is then what counts.
#pragma once

#include "spaces/projection.hpp"

namespace clipscope::experiments {

// The pinhole camera of OpenCV and of most calibrations, all in px: focal lengths, principal point
// and size of the image. x goes right and y down; the centre of the top left pixel is (0, 0), so
// that the image reaches from (-1/2, -1/2) to (width - 1/2, height - 1/2). No skew, no distortion.
struct Intrinsics {
  double fx, fy, cx, cy, width, height;

  friend bool operator==(const Intrinsics&, const Intrinsics&) = default;
};

// The frustum of the image: the side at pixel px has x = near (px - cx) / fx, the one at py has
// y = near (cy - py) / fy. An infinite `far` is an infinite far plane.
// Errors: UsageError unless fx, fy, width and height are finite and > 0, cx and cy finite, and
// 0 < near < far.
Frustum<double> intrinsics_frustum(const Intrinsics& intrinsics, double near, double far);

// The symmetric perspective frustum: top = near tan(fovy / 2), right = aspect top, each computed in
// double and rounded to float once. These floats *are* the frustum. An infinite `far` is an
// infinite far plane.
// Errors: UsageError naming the option unless 0 < fovy < 180, 0 < aspect and 0 < near < far hold,
// also after rounding.
Frustum<float> perspective_frustum(double fovy_degrees, double aspect, double near, double far);

// Each number rounded to float once. `option`: what the numbers were given by.
// Errors: UsageError if it encloses no volume then.
Frustum<float> rounded_frustum(const Frustum<double>& frustum, const char* option);

}  // namespace clipscope::experiments

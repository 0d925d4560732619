// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which numerator makes depth z''/w: the linear one in use, and the quadratic one that would make it
// proportional to distance.
//
//   linear     z'' = ((f + n) d - 2 f n) / (f - n)      z''/d is hyperbolic in d
//   quadratic  z'' = (2 d^2 - (f + n) d) / (f - n)      z''/d is linear in d
//
// for a point at the distance d = w in front of the eye; both are -1 at d = n and 1 at d = f. What a
// rasterizer asks of depth is more than order: it interpolates z''/w linearly over the screen, so
// the image of a straight line must be straight.
// Source: Newman and Sproull, "Principles of Interactive Computer Graphics", 1979, chapter 23.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/scenes/random.hpp"

namespace clipscope::experiments {

enum class DepthForm { linear, quadratic };

// z''/w at the distance d.
template <class N>
N depth_ndc(DepthForm form, const N& d, const N& n, const N& f) {
  if (form == DepthForm::linear) {
    const N numerator = ((f + n) * d - N(2) * f * n) / (f - n);
    return numerator / d;
  }
  const N numerator = (N(2) * d * d - (f + n) * d) / (f - n);
  return numerator / d;
}

// One property of one form, on random input.
struct DepthCheck {
  std::string_view form, property, arithmetic;
  std::size_t samples = 0, violations = 0;
  double deviation_ndc = 0;  // the largest; where the property has none, 0
  double deviation_m = 0;    // the same as a distance
};

// In exact arithmetic, where not said otherwise:
//   monotone                    a farther float has a larger depth; neighbouring floats
//   monotone, float and double  the same computed in that arithmetic, equal depth allowed
//   lines stay straight         an edge's depth at a point of the screen, interpolated between its ends, is
//                               the depth of the edge's point seen there; deviation: the difference
//   nearer wins                 of two edges seen at one point of the screen the nearer has the smaller
//                               interpolated depth
// for both forms. Pre-condition: 0 < near < far.
std::vector<DepthCheck> check_depth_forms(float near, float far, std::size_t samples,
                                          Random& random);

// The largest deviation of an edge from near to far in the quadratic form: 2 (sqrt(r) - 1) / (sqrt(r) + 1)
// with r = far / near, in NDC. At the screen parameter s the edge's point has the parameter
// t = s / (s + (1 - s) r), and s - t is largest at s = sqrt(r) / (1 + sqrt(r)).
double largest_line_deviation(double far_near_ratio);

// A view-space point taken to clip space.
struct EyePlanePoint {
  std::string_view arithmetic;
  double x = 0, y = 0, z = 0, w = 0;
  bool finite_ndc = false;  // x/w, y/w and z/w exist
};
// (1, 1, 0) with left = bottom = -1, right = top = 1, near = 1, far = 10: exact, in float, in double.
std::vector<EyePlanePoint> point_beside_the_eye();

}  // namespace clipscope::experiments

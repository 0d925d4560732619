// SPDX-License-Identifier: GPL-3.0-or-later
//
// The error of affine interpolation: attributes taken to be linear on the screen, where in truth
// a/w and 1/w are.
//
// Along an edge from w0 to w1 the screen's parameter s stands for the edge's own parameter
//
//   t(s) = s w0 / ((1 - s) w1 + s w0)
//
// (Blinn, "Hyperbolic Interpolation", 1992). With r = w_max / w_min, |t(s) - s| is largest where s,
// from the nearer end, is sqrt(r) / (1 + sqrt(r)) or 1 minus that, and there it is
//
//   b(r) = (sqrt(r) - 1) / (sqrt(r) + 1).
//
// In a triangle the truth weighs each corner by s_i / w_i. Moving weight s between the corners by
// factors that differ by at most r moves any attribute by at most b(r) times its range: the bound
// holds inside, too. More than that, along a line of constant w truth and affine answer are both
// linear: the largest error of a triangle lies on one of its edges, and is |a1 - a0| b(w1 / w0).
//
// All templates compute in N: a double, or a rational that rounds nothing.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace clipscope::experiments::perspective {

// t(s) of an edge. Pre-condition: w0, w1 > 0 and 0 <= s <= 1.
template <class N>
N edge_parameter(const N& s, const N& w0, const N& w1) {
  const N from_end = s * w0;
  const N sum = (N(1) - s) * w1 + from_end;
  return N(from_end / sum);
}

// b(r), from the root of r: exact where the root is. Pre-condition: root >= 1.
template <class N>
N affine_bound_of_root(const N& root) {
  return N((root - N(1)) / (root + N(1)));
}

// b(r) >= 0 for w0 / w1 = r or 1 / r, in units of the attribute's range.
inline double affine_bound(double w0, double w1) {
  const double a = std::sqrt(std::max(w0, w1)), b = std::sqrt(std::min(w0, w1));
  return (a - b) / (a + b);
}

// The r with b(r) = error: ((1 + error) / (1 - error))^2. Pre-condition: 0 <= error < 1.
template <class N>
N ratio_at_error(const N& error) {
  const N root = (N(1) + error) / (N(1) - error);
  return N(root * root);
}

// A corner as the affine error sees it.
template <class N>
struct AffineCorner {
  N w, attribute;
};

// Truth less affine answer at the point that lies on the screen at the weights, which need not sum
// to 1. Pre-condition: w > 0, no weight negative, their sum positive.
template <class N>
N affine_error_at(const std::array<AffineCorner<N>, 3>& corners, const std::array<N, 3>& weights) {
  N truth(0), truth_weight(0), affine(0), affine_weight(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const N over_w = weights[i] / corners[i].w;
    truth = truth + N(over_w * corners[i].attribute);
    truth_weight = truth_weight + over_w;
    affine = affine + N(weights[i] * corners[i].attribute);
    affine_weight = affine_weight + weights[i];
  }
  return N(truth / truth_weight - affine / affine_weight);
}

}  // namespace clipscope::experiments::perspective

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The largest affine error that a search finds for a ratio of w, against the bound, without any rounding.
//
// Guarantees: edges and triangles are made of rationals and judged in rationals; `attained` and `beyond`
// are decided exactly. A search by points gives a lower bound of the largest error.
#pragma once

#include <cstddef>
#include <cstdint>

namespace clipscope::experiments {

struct EdgeSearch {
  double ratio = 0;  // w_max / w_min
  double bound = 0;  // b(ratio)
  double on_edges =
      0;  // the largest error on evenly spaced points of the edge, in shares of its range
  double inside = 0;      // the same strictly inside of random triangles
  bool attained = false;  // the error where it should be largest equals the bound, exactly
  std::int64_t points = 0;
  std::int64_t beyond = 0;  // points where the error is above the bound, exactly
};

struct EdgeSearchOptions {
  int edge_steps = 1024;
  int triangles = 2000;
  std::uint64_t seed = 1;
};

// The ratio is root^2: a perfect square, so that the bound is rational. Pre-condition: root >= 1, and its
// square is a double.
EdgeSearch search_edges(double root, const EdgeSearchOptions& options);

// Whether the error numerator / denominator is that of an edge at its worst point, to the bit of a rational,
// where the ratio is the one that the closed form gives for it. Pre-condition: 0 <= it < 1.
bool is_error_at_its_ratio(int numerator, int denominator);

// The smallest ratio at which the error, sought along the edge without use of the closed form, reaches
// `error`. Relative error: below 1e-12 (see the source).
// Pre-condition: 0 < error < 0.9.
double measured_ratio_at_error(double error);

}  // namespace clipscope::experiments

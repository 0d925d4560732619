// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ranges and tics of a plot's axis, and where along it a value lies.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "experiments/report/plot.hpp"

namespace clipscope::experiments {

struct Tic {
  double at = 0;
  std::string label;  // UTF-8; empty: a minor tic
};

struct Scale {
  bool logarithmic = false;
  double low = 0, high = 1;  // low < high; both > 0 if logarithmic
  std::vector<Tic> tics;     // ascending, all in [low, high]

  // Whether a value has a place on the axis: finite, and positive if logarithmic. It may lie outside
  // [low, high].
  bool can_show(double value) const;
  // 0 at low, 1 at high. Pre-condition: can_show(value).
  double fraction(double value) const;
};

struct ScaleOptions {
  bool bars = false;          // from 0, or from a whole power of ten beneath the shortest bar
  std::size_t most_tics = 8;  // labelled ones; at least 3
};

// A scale that holds all values that can be shown, with some room about them, within the axis's own
// limits where it has any. Without a value that can be shown: [0, 1], or [1, 10] if logarithmic.
Scale make_scale(const Axis& axis, std::span<const double> values, const ScaleOptions& options);

}  // namespace clipscope::experiments

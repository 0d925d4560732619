// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/containment.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace clipscope::experiments {
namespace {

// By how much x is beyond a bound of -1, 0 or 1, upwards or downwards. The nearest double of a
// wider scalar settles what is within: rounding keeps order, and the bounds are doubles.
double beyond(const Number& x, double bound, bool upwards) {
  if (!is_finite(x)) return std::numeric_limits<double>::infinity();
  if (upwards ? x.value < bound : x.value > bound) return 0;
  const Exact excess = to_exact(x) - Exact(bound);
  return std::max(0.0, nearest_double(upwards ? excess : Exact(-excess)));
}

}  // namespace

DepthBounds::DepthBounds(const ClipVolume& volume)
    : low(!volume.depth_clamp.near), high(!volume.depth_clamp.far) {
  if (volume.depth == DepthRange::reversed) std::swap(low, high);
}

double overshoot(const ClipVolume& volume, const PolygonView& polygon) {
  const DepthBounds is_bounded(volume);
  const double lowest_z = volume.depth == DepthRange::minus_one_to_one ? -1 : 0;
  double largest = 0;
  for (const VertexView& v : polygon) {
    for (const std::size_t c : {0u, 1u}) {
      largest = std::max({largest, beyond(v[c], 1, true), beyond(v[c], -1, false)});
    }
    if (is_bounded.low) largest = std::max(largest, beyond(v[2], lowest_z, false));
    if (is_bounded.high) largest = std::max(largest, beyond(v[2], 1, true));
  }
  return largest;
}

}  // namespace clipscope::experiments

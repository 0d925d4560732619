// SPDX-License-Identifier: GPL-3.0-or-later
//
// How well a depth buffer tells distances apart: resolution, order of neighbours, distinct values, error.
//
// Source of the order of neighbours at logarithmically spread distances: Reed, "Depth Precision
// Visualized", 2015, after Upchurch and Desbrun, 2012.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "experiments/depth/depth_buffer.hpp"
#include "experiments/scenes/random.hpp"

namespace clipscope::experiments {

// Random distances from near to far, one in each of `count` logarithmically equal pieces, strictly
// ascending; fewer where two fall onto the same float.
std::vector<float> spread_distances(float near, float far, std::size_t count, Random& random);

// Of neighbours in an ascending list: how many does the buffer put in the wrong order, how many does it
// not tell apart?
struct NeighbourOrder {
  std::size_t pairs = 0, misordered = 0, tied = 0;
};
NeighbourOrder neighbour_order(const DepthBuffer& buffer, std::span<const float> distances);

// The number of different values stored for the distances.
std::size_t distinct_values(const DepthBuffer& buffer, std::span<const float> distances);

// The largest DepthBuffer::error_ulp over every `stride`-th distance, and where it is.
struct LargestError {
  double ulp = 0;
  float distance = 0;
};
LargestError largest_error(const DepthBuffer& buffer, std::span<const float> distances,
                           std::size_t stride);

// The smallest separation in metres at which 64 pairs of points about a distance are all told apart in the
// right order; multiples of the float spacing there are tried, by doubling and then bisection. The
// second point is the nearer one, but at the near plane the farther one. Nothing if not even the near
// plane is told from the distance.
// Does not guarantee: that every larger separation is told apart, too.
std::optional<double> resolution(const DepthBuffer& buffer, float distance);

}  // namespace clipscope::experiments

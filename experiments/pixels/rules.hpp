// SPDX-License-Identifier: GPL-3.0-or-later
//
// ValueRule: what one channel of one quantity of one primitive may be.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "experiments/pixels/accuracy.hpp"
#include "experiments/pixels/coverage.hpp"

namespace clipscope::experiments {

enum class Clamping : std::uint8_t { never, may, must };  // to 0 and 1

struct ValueRule {
  Quantity quantity = Quantity::smooth;
  std::size_t channel = 0;
  Interpolant interpolant = {};
  bool has_linear_twin = false;  // without perspective is right, too
  Clamping clamping = Clamping::never;
  // What the vertices of the clipped polygon have; of a point its own value.
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
  double size = 0;  // the greatest magnitude among them
  double slack = 0;
};

// Of a triangle with an area or a line, for the quantities that are asked for: smooth,
// noperspective, z and w of frag_coord, clip_distances, depth.
std::vector<ValueRule> rules_of(const DrawCall& call, std::span<const std::uint32_t> vertices);

}  // namespace clipscope::experiments

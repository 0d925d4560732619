// SPDX-License-Identifier: GPL-3.0-or-later
//
// The attributes of vertices that clipping makes, by the ratio of w over the triangle: what cutting after the
// divide costs where it interpolates attributes as it does positions, and what it costs where it doesn't.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "experiments/store/cell_record.hpp"

namespace clipscope::experiments {

// Triangles whose vertices lie in front of the near plane and whose largest w is `ratio` times the
// smallest, to the bit; some vertex is outside a side plane, and something is visible. Attributes lie in
// [0, 1]. The frustum is `cut_frustum()`. Pre-condition: ratio >= 1 is a float, at most 2^15.
std::vector<SceneTriangle> cut_triangles(float ratio, std::size_t count, std::uint64_t seed);
Frustum<float> cut_frustum();

struct CutError {
  std::int64_t triangles = 0;  // with the right vertices
  double max = 0;              // the largest error of an attribute at a vertex, absolute
  std::string worst;           // the triangle with it, as replay_text (measure/sweep.hpp) gives it
};

CutError attribute_error_of_cut(const AnyContestant& contestant,
                                const std::vector<SceneTriangle>& triangles);

WorstInput worst_input(const AnyContestant& contestant, const CutError& error);

}  // namespace clipscope::experiments

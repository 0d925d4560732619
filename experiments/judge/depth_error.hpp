// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far z is off, apart from x, y and 1/w, with which a Comparison counts it (compare.hpp).
#pragma once

#include "experiments/judge/compare.hpp"

namespace clipscope::experiments {

// The largest error of z over the vertices, absolute in NDC; vertices are matched as by `compare`.
// 0 unless both have the same number of distinct vertices.
double largest_depth_error(const PolygonView& polygon, const TruthPolygon& truth);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Is a polygon of floats the exact one, rounded once to nearest, ties to even, bit for bit?
#pragma once

#include <span>
#include <string>

#include "reference/exact_clip.hpp"
#include "spaces/vertex.hpp"

namespace clipscope::experiments {

// What differs; empty if nothing does. The exact answer is nothing where a z rounds to infinity. Vertices
// are compared in order, from the first on; further ones must have the place of one of them, and if
// there are fewer than three, which have no area, nothing is an answer as well. 0 is +0.
// Pre-condition: the triangle is finite.
template <int K>
std::string misrounded(const reference::Truth& truth, const reference::InputTriangle& triangle,
                       std::span<const NdcVertex<float, K>> polygon);

}  // namespace clipscope::experiments

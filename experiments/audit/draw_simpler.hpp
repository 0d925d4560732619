// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is simpler than a draw call, apart from its numbers; and its numbers as a hard case, whose
// simplifications are known (experiments/shrink/simpler_cases.hpp).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/drawcalls/draw_call.hpp"

namespace clipscope::experiments {

// Those primitives of the call, by number, as a list of points, lines or triangles, with the
// vertices that they use; each keeps its winding and its provoking vertex. With indices if they
// share vertices, else without.
DrawCall with_primitives(const DrawCall& call, std::span<const std::size_t> numbers);

// One option less, or one step to the usual: quantities, sizes, viewport, order.
std::vector<DrawCall> simpler_settings(const DrawCall& call);

// All vertices of the call as those of one case in clip space, whatever their number: clip
// distances and then the varying for attributes.
HardCase numbers_of(const DrawCall& call);

// The call with the numbers, depth range, depth clamp and clip distances of the case; attributes
// that the case has no more are 0.
DrawCall with_numbers(DrawCall call, const HardCase& numbers);

}  // namespace clipscope::experiments

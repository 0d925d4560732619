// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draw calls for the judge and for who is judged.
#pragma once

#include <random>

#include "experiments/drawcalls/draw_call.hpp"

namespace clipscope::experiments {

Quantities all_quantities();

// A target of that size, the viewport all of it, every quantity.
DrawCall call_of(Topology topology, std::vector<DrawVertex> vertices, int size = 32);

// A vertex with a varying of its own.
DrawVertex vertex_at(float x, float y, float z, float w, float varying = 0);

// Small integers, w from -3 to 3, and what goes with them: strips, fans, depth clamp, clip
// distances, both depth ranges, provoking vertices, viewports.
DrawCall lattice_call(std::mt19937& random);

// As many vertices that are far away (2^10 to 2^24), tiny or huge as a whole, or random floats.
DrawCall far_call(std::mt19937& random);
DrawCall scaled_call(std::mt19937& random);
DrawCall random_call(std::mt19937& random);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The plainest draw call of some vertices, and small changes of it.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "experiments/drawcalls/driver.hpp"
#include "experiments/scenes/random.hpp"

namespace clipscope::experiments {

inline constexpr int kSmallTarget = 32, kLargeTarget = 256;  // px
inline constexpr int kLargeViewport = 8192;                  // px

// Dyadic numbers in [-4, 4], other ones for each vertex, so that a value tells where it is from:
// multiples of 1/2; 1 for every third vertex, else 0; multiples of 1/4; and 1 for all.
std::array<float, 4> varying_of(std::size_t vertex);

// Positive and negative ones, so that each triangle is cut by the first of them.
std::array<float, kMaxClipDistances> clip_distances_of(std::size_t vertex);

// A target of 32 px and a viewport as large, the depth range and the provoking vertex that the
// driver has, minus_one_to_one and the last one where there is a choice; all that can be read back
// but clip distances, of which there are none, and gl_PrimitiveID: one driver draws nothing at all
// for a shader that reads it, which would hide everything else.
DrawCall plain_call(std::string name, Topology topology, std::span<const std::array<float, 4>>,
                    const DriverInfo& info);

// The call with the label behind its name: "name (label)", "name (label, another)".
DrawCall labelled(DrawCall call, std::string_view label);

// Clip coordinates of the same point of the volume with the other depth range: z (minus_one_to_one)
// and (z + w) / 2 (zero_to_one), rounded to float. Pre-condition: neither is `reversed`.
void set_depth_range(DrawCall& call, DepthRange range);

void set_size(DrawCall& call, int width, int height);  // of the target and of the viewport

// A viewport of 2^10 px up to what the driver has, and the target at its first corner, its last, in
// its middle or anywhere in it, across and up alike or apart.
void set_large_viewport(DrawCall& call, const DriverInfo& info, Random& random);

// So many clip distances, of clip_distances_of, which are asked for.
void set_clip_distances(DrawCall& call, int count);

// Whether all coordinates, varyings and clip distances are numbers.
bool is_finite(const DrawCall& call);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The shaders, as SPIR-V for Vulkan 1.0, compiled when this is built (CMakeLists.txt).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "experiments/drawcalls/draw_call.hpp"

namespace clipscope::experiments {

using SpirV = std::span<const std::uint32_t>;

SpirV vertex_shader(int clip_distances);       // 0 to 8
SpirV values_shader(const Quantities& reads);  // covered, and those of shaders/values.frag in it
SpirV hits_shader();
SpirV clip_distances_shader(int clip_distances);  // 1 to 8

}  // namespace clipscope::experiments

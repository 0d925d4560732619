// SPDX-License-Identifier: GPL-3.0-or-later
//
// The shaders of piglit's tests and Amber's scripts: they turn what is wrong into a colour.
//
// Green is right and red is wrong, so that 8 bits of colour suffice, and an error of any size is
// seen. Fragments that have to be counted are by an atomic counter, in Vulkan in a buffer.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/reproductions/check.hpp"

namespace clipscope::experiments {

enum class Dialect { opengl, vulkan };  // GLSL 3.30; GLSL 4.50 for SPIR-V

struct Shaders {
  std::string vertex, fragment;  // each ends with a line feed
};
// `paint`: the colour of all fragments, instead of what is checked; of depth it has to be given.
Shaders shaders_of(const DrawCall& call, const Check& check, Dialect dialect,
                   std::string_view paint = "");

inline constexpr std::string_view kGreen = "vec4(0.0, 1.0, 0.0, 1.0)";
inline constexpr std::string_view kRed = "vec4(1.0, 0.0, 0.0, 1.0)";

// An input of the vertex shader, a vec4; those that the shaders have, by location from 0 on.
struct VertexInput {
  std::string_view name;
  std::array<float, 4> (*of)(const DrawVertex& vertex);
};
std::vector<VertexInput> inputs_of(const DrawCall& call, const Check& check);
// Its components, as decimals with blanks between them.
std::string input_text(const VertexInput& input, const DrawVertex& vertex);

// Two triangles over the whole viewport whose depth in the window is that, inside of all planes.
std::vector<DrawVertex> cover(float window_depth, DepthRange range);

}  // namespace clipscope::experiments

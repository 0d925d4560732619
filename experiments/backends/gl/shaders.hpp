// SPDX-License-Identifier: GPL-3.0-or-later
//
// The shaders of a pass, in GLSL 3.30 or, with another head, GLSL ES 3.00: text alone.
//
// A shader declares and reads no more than its outputs need, so that a driver's fault in one
// quantity spoils no other.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/drawcalls/draw_call.hpp"

namespace clipscope::experiments {

// What the fragment shader writes to one attachment.
struct Output {
  Quantity quantity = Quantity::covered;
  std::string_view expression = {};  // a vec4
  std::size_t channels = 1;          // of the attachment
  std::size_t first = 0;             // the channel of the quantity that its first one is
  float background = 0;              // where no fragment is
};

struct Pass {
  std::vector<Output> outputs = {};
  bool has_depth = false;  // the depth buffer is written
  bool adds_up = false;    // fragments of one pixel are added, else the last one stays
};

// The passes that a draw call takes: one for all that the attachments of OpenGL 3.3 (8 at least)
// hold, one for the hits, and one for gl_PrimitiveID, which comes from a geometry stage in some
// drivers. Pixels without a fragment are 0, their primitive -1.
std::vector<Pass> passes_of(const DrawCall& call);

// What the shaders depend on besides the outputs.
struct ShaderForm {
  int clip_distances = 0;
  bool is_point = false;  // the size of points is written: uniform float point_size
  std::string head = "#version 330 core\n";
};

// Attributes: 0 position, 1 varying, 2 and 3 clip distances.
std::string vertex_shader(const Pass& pass, const ShaderForm& form);
std::string fragment_shader(const Pass& pass, const ShaderForm& form);

}  // namespace clipscope::experiments

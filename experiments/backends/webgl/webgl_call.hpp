// SPDX-License-Identifier: GPL-3.0-or-later
//
// A draw call as draw.js draws it: the text of an object of JavaScript with its shaders in GLSL ES
// 3.00, for the host of WebGL and for web pages.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/backends/gl/shaders.hpp"

namespace clipscope::experiments {

// The passes, each with no more outputs than attachments (4 at least), coverage in the first.
std::vector<Pass> webgl_passes(const DrawCall& call, std::size_t most_attachments);

// Pre-condition: all coordinates, values and distances are finite.
std::string webgl_call(const DrawCall& call, const std::vector<Pass>& passes);

// What defines `class Drawing`, which draws it: the text of draw.js; and of host.js.
std::string_view webgl_drawing();
std::string_view webgl_host();

}  // namespace clipscope::experiments

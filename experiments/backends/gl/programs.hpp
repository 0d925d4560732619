// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs of OpenGL from the text of their shaders.
#pragma once

#include <epoxy/gl.h>

#include <string>

namespace clipscope::experiments {

// Errors: GlError with the driver's words.
GLuint link_program(const std::string& vertex, const std::string& fragment);

}  // namespace clipscope::experiments

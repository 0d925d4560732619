// SPDX-License-Identifier: GPL-3.0-or-later
//
// What OpenGL says is wrong, as an exception: a draw call is refused for it.
#pragma once

#include <epoxy/gl.h>

#include <stdexcept>
#include <string>

namespace clipscope::experiments {

struct GlError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Reports all that glGetError has: "GL_INVALID_OPERATION in glDrawArrays". Errors: GlError.
void check_errors(const std::string& where);

// Forgets what glGetError has.
void forget_errors();

}  // namespace clipscope::experiments

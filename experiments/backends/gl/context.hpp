// SPDX-License-Identifier: GPL-3.0-or-later
//
// An OpenGL context without a window, by EGL 1.4 and up.
#pragma once

#include <epoxy/egl.h>

#include <memory>
#include <stdexcept>

namespace clipscope::experiments {

// The message says what was tried, and how each failed.
struct NoContext : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The calling thread's current context while it lives.
class Context {
 public:
  // The newest core context, 4.6 to 3.3, of the first display that has one: surfaceless
  // (EGL_MESA_platform_surfaceless), each device (EGL_EXT_platform_device), the default one. One
  // that draws in software comes after those that don't, unless LIBGL_ALWAYS_SOFTWARE is set.
  // Errors: NoContext.
  Context();
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

 private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
};

}  // namespace clipscope::experiments

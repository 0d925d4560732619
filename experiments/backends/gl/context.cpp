// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/backends/gl/context.hpp"

#include <dlfcn.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace clipscope::experiments {
namespace {

struct Candidate {
  std::string name;
  EGLDisplay display;
};

// The errors from EGL_NOT_INITIALIZED on.
std::string failed(const char* function) {
  constexpr std::array<std::string_view, 14> kNames = {
      "NOT_INITIALIZED", "BAD_ACCESS",        "BAD_ALLOC",           "BAD_ATTRIBUTE",
      "BAD_CONFIG",      "BAD_CONTEXT",       "BAD_CURRENT_SURFACE", "BAD_DISPLAY",
      "BAD_MATCH",       "BAD_NATIVE_PIXMAP", "BAD_NATIVE_WINDOW",   "BAD_PARAMETER",
      "BAD_SURFACE",     "CONTEXT_LOST"};
  const EGLint error = eglGetError();
  const auto place = static_cast<std::size_t>(error - EGL_NOT_INITIALIZED);
  const std::string name =
      place < kNames.size() ? "EGL_" + std::string(kNames[place]) : std::to_string(error);
  return std::string(function) + " fails with " + name;
}

bool has_client_extension(const char* name) {
  return epoxy_has_egl_extension(EGL_NO_DISPLAY, name);
}

// libepoxy ends the process where there is no EGL.
void require_egl() {
  if (dlopen("libEGL.so.1", RTLD_LAZY | RTLD_LOCAL) != nullptr) return;
  throw NoContext(std::string("EGL is missing: ") + dlerror() + " (Debian package: libegl1)");
}

void add_devices(std::vector<Candidate>& candidates) {
  std::array<EGLDeviceEXT, 16> devices{};
  EGLint count = 0;
  if (!eglQueryDevicesEXT(devices.size(), devices.data(), &count)) return;
  for (EGLint i = 0; i < count; ++i) {
    candidates.push_back({"device " + std::to_string(i),
                          eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT,
                                                   devices[static_cast<std::size_t>(i)], nullptr)});
  }
}

std::vector<Candidate> candidates() {
  std::vector<Candidate> all;
  const bool has_platforms = has_client_extension("EGL_EXT_platform_base");
  if (has_platforms && has_client_extension("EGL_MESA_platform_surfaceless")) {
    all.push_back({"surfaceless", eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA,
                                                           EGL_DEFAULT_DISPLAY, nullptr)});
  }
  if (has_platforms && has_client_extension("EGL_EXT_platform_device")) add_devices(all);
  all.push_back({"the default display", eglGetDisplay(EGL_DEFAULT_DISPLAY)});
  return all;
}

EGLContext newest_context(EGLDisplay display, EGLConfig config) {
  constexpr std::array<std::pair<EGLint, EGLint>, 8> kVersions = {
      {{4, 6}, {4, 5}, {4, 4}, {4, 3}, {4, 2}, {4, 1}, {4, 0}, {3, 3}}};
  for (const std::pair<EGLint, EGLint>& version : kVersions) {
    const std::array<EGLint, 7> attributes = {EGL_CONTEXT_MAJOR_VERSION_KHR,
                                              version.first,
                                              EGL_CONTEXT_MINOR_VERSION_KHR,
                                              version.second,
                                              EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
                                              EGL_NONE};
    EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
    if (context != EGL_NO_CONTEXT) return context;
  }
  return EGL_NO_CONTEXT;
}

// Nothing of it is drawn to: a context without a surface is an extension.
EGLSurface small_surface(EGLDisplay display, EGLConfig config) {
  if (epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context")) return EGL_NO_SURFACE;
  const std::array<EGLint, 5> size = {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
  return eglCreatePbufferSurface(display, config, size.data());
}

// Makes a context of the display current. Returns why not; empty if it is.
std::string make_current(EGLDisplay display) {
  if (display == EGL_NO_DISPLAY) return "there is no such display";
  if (!eglInitialize(display, nullptr, nullptr)) return failed("eglInitialize");
  if (!eglBindAPI(EGL_OPENGL_API)) return failed("eglBindAPI of OpenGL");
  const std::array<EGLint, 5> wanted = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                        EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display, wanted.data(), &config, 1, &count)) {
    return failed("eglChooseConfig");
  }
  if (count == 0) return "no configuration has OpenGL and pixel buffers";
  EGLContext context = newest_context(display, config);
  if (context == EGL_NO_CONTEXT) return "no core context of OpenGL 3.3 or above";
  EGLSurface surface = small_surface(display, config);
  return eglMakeCurrent(display, surface, surface, context) ? "" : failed("eglMakeCurrent");
}

// Gives up what make_current made.
void release(EGLDisplay display) {
  if (display == EGL_NO_DISPLAY) return;
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglTerminate(display);
}

// Whether the current context draws by the processor.
bool is_software() {
  const GLubyte* text = glGetString(GL_RENDERER);
  const std::string_view renderer = text == nullptr ? "" : reinterpret_cast<const char*>(text);
  constexpr std::array<std::string_view, 3> kNames = {"llvmpipe", "softpipe", "swrast"};
  return std::ranges::any_of(
      kNames, [&](std::string_view name) { return renderer.find(name) != std::string_view::npos; });
}

}  // namespace

// Mesa's surfaceless display draws in software where the graphics card has a driver of its maker,
// which a later display leads to. So software is taken first only where it is asked for.
Context::Context() {
  require_egl();
  const bool asks_for_software = std::getenv("LIBGL_ALWAYS_SOFTWARE") != nullptr;
  std::string tried;
  for (const bool takes_software : {asks_for_software, true}) {
    tried.clear();
    for (const Candidate& candidate : candidates()) {
      std::string reason = make_current(candidate.display);
      if (reason.empty() && !takes_software && is_software()) reason = "it draws in software";
      if (reason.empty()) {
        display_ = candidate.display;
        return;
      }
      release(candidate.display);
      tried += (tried.empty() ? "" : "; ") + candidate.name + ": " + reason;
    }
  }
  throw NoContext("no OpenGL context without a window: " + tried);
}

Context::~Context() { release(display_); }

}  // namespace clipscope::experiments

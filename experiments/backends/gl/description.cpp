// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/backends/gl/description.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <string>

namespace clipscope::experiments {
namespace {

std::string text_of(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text == nullptr ? "" : reinterpret_cast<const char*>(text);
}

GLint number_of(GLenum name) {
  GLint number = 0;
  glGetIntegerv(name, &number);
  return number;
}

// "4.5 (Core Profile) Mesa 22.3.6" without the version of the API and the profile; the vendor where
// nothing is left.
std::string version_of_driver() {
  std::string text = text_of(GL_VERSION);
  text.erase(0, std::min(text.find(' '), text.size()));
  const std::string profile = "(Core Profile)";
  const std::size_t place = text.find(profile);
  if (place != std::string::npos) text.erase(place, profile.size());
  text.erase(0, text.find_first_not_of(' '));
  return text.empty() ? text_of(GL_VENDOR) + " " + text_of(GL_VERSION) : text;
}

int max_size() {
  std::array<GLint, 2> viewport{};
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
  return std::min({viewport[0], viewport[1], number_of(GL_MAX_RENDERBUFFER_SIZE)});
}

float max_point_size() {
  std::array<float, 2> range = {1, 1};
  glGetFloatv(GL_POINT_SIZE_RANGE, range.data());
  return range[1];
}

}  // namespace

DriverInfo describe_driver() {
  DriverInfo info;
  info.api = GraphicsApi::opengl;
  info.api_version = std::to_string(number_of(GL_MAJOR_VERSION)) + "." +
                     std::to_string(number_of(GL_MINOR_VERSION)) + " core";
  info.renderer = text_of(GL_RENDERER);
  info.version = version_of_driver();
  info.subpixel_bits = number_of(GL_SUBPIXEL_BITS);
  info.max_size = max_size();
  info.max_clip_distances = std::min(number_of(GL_MAX_CLIP_DISTANCES), kMaxClipDistances);
  info.max_point_size = max_point_size();
  info.minus_one_to_one = true;
  info.zero_to_one = epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_ARB_clip_control");
  info.depth_clamp = info.provoking_first = info.provoking_last = true;  // OpenGL 3.2 and up
  info.quantities.set();
  return info;
}

}  // namespace clipscope::experiments

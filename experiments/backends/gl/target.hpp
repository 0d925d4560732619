// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is drawn to and read back: 32-bit float renderbuffers of one size.
#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "experiments/backends/gl/shaders.hpp"

namespace clipscope::experiments {

// Images are made when a pass first needs them, and kept.
class Target {
 public:
  // px
  Target(int width, int height) : width_(width), height_(height) {}
  ~Target();
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;

  int width() const { return width_; }
  int height() const { return height_; }

  // Makes it what is drawn to, cleared; output k of the pass goes to attachment k. Errors: GlError.
  void begin(const Pass& pass);
  // Adds what was drawn since to the pixels.
  void read(const Pass& pass, Pixels& pixels);

 private:
  GLuint framebuffer(const Pass& pass);
  void attach(GLenum attachment, GLenum format);
  void read(const Output& output, std::vector<float>& values);

  int width_, height_;
  // By the channels of each attachment, and whether there is depth.
  std::map<std::pair<std::vector<std::size_t>, bool>, GLuint> framebuffers_ = {};
  std::map<std::pair<GLenum, GLenum>, GLuint> images_ = {};  // by attachment and format
  std::vector<float> block_ = {};
};

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/backends/gl/target.hpp"

#include <array>
#include <string>

#include "experiments/backends/gl/errors.hpp"

namespace clipscope::experiments {
namespace {

struct Format {
  GLenum of_image, of_pixels;
};

Format format_of(std::size_t channels) {
  if (channels == 1) return {GL_R32F, GL_RED};
  if (channels == 2) return {GL_RG32F, GL_RG};
  return {GL_RGBA32F, GL_RGBA};
}

}  // namespace

Target::~Target() {
  for (const auto& framebuffer : framebuffers_) glDeleteFramebuffers(1, &framebuffer.second);
  for (const auto& image : images_) glDeleteRenderbuffers(1, &image.second);
}

void Target::attach(GLenum attachment, GLenum format) {
  GLuint& image = images_[{attachment, format}];
  if (image == 0) {
    glGenRenderbuffers(1, &image);
    glBindRenderbuffer(GL_RENDERBUFFER, image);
    glRenderbufferStorage(GL_RENDERBUFFER, format, width_, height_);
  }
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, image);
}

GLuint Target::framebuffer(const Pass& pass) {
  std::vector<std::size_t> channels;
  for (const Output& output : pass.outputs) channels.push_back(output.channels);
  GLuint& name = framebuffers_[{channels, pass.has_depth}];
  if (name != 0) return name;
  glGenFramebuffers(1, &name);
  glBindFramebuffer(GL_FRAMEBUFFER, name);
  std::vector<GLenum> attachments;
  for (std::size_t k = 0; k < channels.size(); ++k) {
    attachments.push_back(static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + k));
    attach(attachments[k], format_of(channels[k]).of_image);
  }
  if (pass.has_depth) attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F);
  glDrawBuffers(static_cast<GLsizei>(attachments.size()), attachments.data());
  check_errors("glRenderbufferStorage");
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    throw GlError("glCheckFramebufferStatus returns " + std::to_string(status));
  }
  return name;
}

void Target::begin(const Pass& pass) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer(pass));
  for (std::size_t k = 0; k < pass.outputs.size(); ++k) {
    const float value = pass.outputs[k].background;
    const std::array<float, 4> background = {value, value, value, value};
    glClearBufferfv(GL_COLOR, static_cast<GLint>(k), background.data());
  }
  if (pass.has_depth) glClearBufferfv(GL_DEPTH, 0, &kNoDepth);
}

void Target::read(const Output& output, std::vector<float>& values) {
  const auto pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  const std::size_t channels_there = channels(output.quantity);
  const GLenum format = format_of(output.channels).of_pixels;
  values.resize(pixels * channels_there);
  if (output.channels == channels_there) {
    glReadPixels(0, 0, width_, height_, format, GL_FLOAT, values.data());
    return;
  }
  block_.resize(pixels * output.channels);
  glReadPixels(0, 0, width_, height_, format, GL_FLOAT, block_.data());
  for (std::size_t p = 0; p < pixels; ++p) {
    for (std::size_t c = 0; c < output.channels; ++c) {
      values[p * channels_there + output.first + c] = block_[p * output.channels + c];
    }
  }
}

void Target::read(const Pass& pass, Pixels& pixels) {
  for (std::size_t k = 0; k < pass.outputs.size(); ++k) {
    glReadBuffer(static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + k));
    read(pass.outputs[k], pixels.values[bit(pass.outputs[k].quantity)]);
  }
  if (!pass.has_depth) return;
  std::vector<float>& depth = pixels.values[bit(Quantity::depth)];
  depth.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  glReadPixels(0, 0, width_, height_, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
}

}  // namespace clipscope::experiments

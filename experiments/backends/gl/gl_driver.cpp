// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/backends/gl/gl_driver.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "experiments/backends/gl/description.hpp"
#include "experiments/backends/gl/errors.hpp"
#include "experiments/backends/gl/programs.hpp"

namespace clipscope::experiments {
namespace {

GLenum mode_of(Topology topology) {
  constexpr std::array<GLenum, 6> kModes = {GL_POINTS,    GL_LINES,          GL_LINE_STRIP,
                                            GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN};
  return kModes[static_cast<std::size_t>(topology)];
}

void enable(GLenum what, bool is_on) { (is_on ? glEnable : glDisable)(what); }

void attribute(GLuint location, GLint size, std::size_t offset) {
  glEnableVertexAttribArray(location);
  glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, sizeof(DrawVertex),
                        reinterpret_cast<const void*>(offset));
}

// Clip distances are off where the call has none, whatever the one before had.
void set_clip_distances(int count, int most) {
  for (int i = 0; i < most; ++i) enable(static_cast<GLenum>(GL_CLIP_DISTANCE0 + i), i < count);
}

// Of a call without clip distances they are 0, and no shader can say so.
void fill_without_distances(const DrawCall& call, Pixels& pixels) {
  if (!call.quantities[bit(Quantity::clip_distances)]) return;
  pixels.values[bit(Quantity::clip_distances)].resize(pixels.of(Quantity::covered).size() *
                                                      channels(Quantity::clip_distances));
}

}  // namespace

GlDriver::GlDriver() : info_(describe_driver()) {
  glGenBuffers(1, &vertices_);
  glGenBuffers(1, &indices_);
  glGenVertexArrays(1, &array_);
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  attribute(0, 4, offsetof(DrawVertex, position));
  attribute(1, 4, offsetof(DrawVertex, varying));
  attribute(2, 4, offsetof(DrawVertex, clip_distances));
  attribute(3, 4, offsetof(DrawVertex, clip_distances) + 4 * sizeof(float));
  glDisable(GL_DITHER);
  glDisable(GL_MULTISAMPLE);
  glEnable(GL_PROGRAM_POINT_SIZE);
  glFrontFace(GL_CCW);  // positive orientation in (x_ndc, y_ndc)
  glDepthFunc(GL_ALWAYS);
  glBlendFunc(GL_ONE, GL_ONE);
  glClampColor(GL_CLAMP_READ_COLOR, GL_FALSE);
  check_errors("preparing the context");
}

GlDriver::~GlDriver() = default;

void GlDriver::set_state(const DrawCall& call) {
  if (info_.zero_to_one) {
    const bool is_zero_to_one = call.volume.depth == DepthRange::zero_to_one;
    glClipControl(GL_LOWER_LEFT, is_zero_to_one ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
  }
  enable(GL_DEPTH_CLAMP, static_cast<bool>(call.volume.depth_clamp));
  set_clip_distances(call.volume.clip_distances, info_.max_clip_distances);
  glProvokingVertex(call.provoking == ProvokingVertex::first ? GL_FIRST_VERTEX_CONVENTION
                                                             : GL_LAST_VERTEX_CONVENTION);
  glViewport(call.viewport.x, call.viewport.y, call.viewport.width, call.viewport.height);
}

void GlDriver::upload(const DrawCall& call) {
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(call.vertices.size() * sizeof(DrawVertex)),
               call.vertices.data(), GL_STREAM_DRAW);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(call.indices.size() * sizeof(std::uint32_t)),
               call.indices.data(), GL_STREAM_DRAW);
}

GLuint GlDriver::program_of(const Pass& pass, const ShaderForm& form) {
  const std::string vertex = vertex_shader(pass, form), fragment = fragment_shader(pass, form);
  GLuint& program = programs_[vertex + fragment];
  if (program == 0) program = link_program(vertex, fragment);
  return program;
}

void GlDriver::draw_pass(const DrawCall& call, const Pass& pass, Pixels& pixels) {
  const bool is_point = call.topology == Topology::points;
  const GLuint program = program_of(pass, {call.volume.clip_distances, is_point});
  target_->begin(pass);
  glUseProgram(program);
  if (is_point) glUniform1f(glGetUniformLocation(program, "point_size"), call.point_size);
  enable(GL_DEPTH_TEST, pass.has_depth);
  enable(GL_BLEND, pass.adds_up);
  check_errors("preparing a pass");
  if (call.indices.empty()) {
    glDrawArrays(mode_of(call.topology), 0, static_cast<GLsizei>(call.vertices.size()));
    check_errors("glDrawArrays");
  } else {
    glDrawElements(mode_of(call.topology), static_cast<GLsizei>(call.indices.size()),
                   GL_UNSIGNED_INT, nullptr);
    check_errors("glDrawElements");
  }
  target_->read(pass, pixels);
  check_errors("glReadPixels");
}

Drawn GlDriver::draw(const DrawCall& call) {
  forget_errors();
  try {
    if (!target_ || target_->width() != call.width || target_->height() != call.height) {
      target_ = std::make_unique<Target>(call.width, call.height);
    }
    set_state(call);
    upload(call);
    check_errors("setting the state");
    Pixels pixels{call.width, call.height};
    for (const Pass& pass : passes_of(call)) draw_pass(call, pass, pixels);
    fill_without_distances(call, pixels);
    return pixels;
  } catch (const GlError& error) {
    target_.reset();
    return DrawFailure{DrawFailure::Kind::refused, error.what()};
  }
}

}  // namespace clipscope::experiments

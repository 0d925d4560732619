// SPDX-License-Identifier: GPL-3.0-or-later
//
// GlDriver: OpenGL 3.3 core and up as a Driver.
#pragma once

#include <epoxy/gl.h>

#include <memory>
#include <string>
#include <unordered_map>

#include "experiments/backends/gl/context.hpp"
#include "experiments/backends/gl/shaders.hpp"
#include "experiments/backends/gl/target.hpp"
#include "experiments/drawcalls/driver.hpp"

namespace clipscope::experiments {

// Errors of the API make a draw call refused. A crash is one of the process.
class GlDriver : public Driver {
 public:
  // Errors: NoContext, GlError.
  GlDriver();
  ~GlDriver() override;

  const DriverInfo& info() const override { return info_; }
  Drawn draw(const DrawCall& call) override;

 private:
  void set_state(const DrawCall& call);
  void upload(const DrawCall& call);
  GLuint program_of(const Pass& pass, const ShaderForm& form);
  void draw_pass(const DrawCall& call, const Pass& pass, Pixels& pixels);

  Context context_;
  DriverInfo info_;
  GLuint vertices_ = 0, indices_ = 0, array_ = 0;
  std::unordered_map<std::string, GLuint> programs_ = {};  // by the text of both shaders
  std::unique_ptr<Target> target_ = {};                    // of the size that was drawn last
};

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/backends/gl/errors.hpp"

#include <string_view>

namespace clipscope::experiments {
namespace {

constexpr int kMostErrors = 16;  // a lost context reports one for ever

std::string name_of(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM: return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE: return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION: return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION: return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY: return "GL_OUT_OF_MEMORY";
    case GL_CONTEXT_LOST: return "GL_CONTEXT_LOST";
    default: return "error " + std::to_string(error);
  }
}

}  // namespace

void check_errors(const std::string& where) {
  std::string names;
  for (int i = 0; i < kMostErrors; ++i) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) break;
    const std::string name = name_of(error);
    if (names.find(name) == std::string::npos) names += (names.empty() ? "" : ", ") + name;
  }
  if (!names.empty()) throw GlError(names + " in " + where);
}

void forget_errors() {
  for (int i = 0; i < kMostErrors && glGetError() != GL_NO_ERROR; ++i) continue;
}

}  // namespace clipscope::experiments

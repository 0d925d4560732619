// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/backends/gl/programs.hpp"

#include <array>

#include "experiments/backends/gl/errors.hpp"

namespace clipscope::experiments {
namespace {

GLuint compile(GLenum stage, const std::string& text) {
  const GLuint shader = glCreateShader(stage);
  const char* begin = text.c_str();
  glShaderSource(shader, 1, &begin, nullptr);
  glCompileShader(shader);
  GLint is_compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &is_compiled);
  if (is_compiled == GL_TRUE) return shader;
  std::array<char, 1000> words{};
  glGetShaderInfoLog(shader, words.size(), nullptr, words.data());
  glDeleteShader(shader);
  throw GlError(std::string("glCompileShader refuses a ") +
                (stage == GL_VERTEX_SHADER ? "vertex" : "fragment") + " shader: " + words.data());
}

}  // namespace

GLuint link_program(const std::string& vertex, const std::string& fragment) {
  const GLuint program = glCreateProgram();
  for (const GLuint shader :
       {compile(GL_VERTEX_SHADER, vertex), compile(GL_FRAGMENT_SHADER, fragment)}) {
    glAttachShader(program, shader);
    glDeleteShader(shader);  // lives as long as the program
  }
  glLinkProgram(program);
  GLint is_linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &is_linked);
  if (is_linked == GL_TRUE) return program;
  std::array<char, 1000> words{};
  glGetProgramInfoLog(program, words.size(), nullptr, words.data());
  glDeleteProgram(program);
  throw GlError(std::string("glLinkProgram refuses: ") + words.data());
}

}  // namespace clipscope::experiments

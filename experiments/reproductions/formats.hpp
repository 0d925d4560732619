// SPDX-License-Identifier: GPL-3.0-or-later
//
// The three formats. Each is empty where the API can't say it.
#pragma once

#include <string>

#include "experiments/reproductions/check.hpp"

namespace clipscope::experiments {

// `about`: lines of prose that say what is wrong, without marks of comments.
struct Case {
  const DrawCall& call;
  Check check;
  std::vector<std::string> about;
};

// For shader_runner: piglit, tests/shaders/shader_runner.c and tests/util/piglit-vbo.cpp.
std::string piglit_test(const Case& it);

// For amber: docs/amber_script.md of github.com/google/amber.
std::string amber_script(const Case& it);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The three formats. Each text is empty where the API can't say it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/reproductions/check.hpp"

namespace clipscope::experiments {

struct Case {
  const DrawCall& call;
  Check check;
  std::vector<std::string> about;  // lines of prose that say what is wrong
};
// The same, and what is right, as lines that `mark` begins.
std::string comment(const Case& it, std::string_view mark);

// For shader_runner: piglit, tests/shaders/shader_runner.c and tests/util/piglit-vbo.cpp.
std::string piglit_test(const Case& it);

// For amber: docs/amber_script.md of github.com/google/amber.
std::string amber_script(const Case& it);

// For a browser with WebGL 2. The verdict, PASS, FAIL or NOT DRAWN, opens its title and its text.
std::string web_page(const Case& it);

}  // namespace clipscope::experiments

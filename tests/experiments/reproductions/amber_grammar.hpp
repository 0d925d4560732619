// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of Amber's language that reproductions are written in: docs/amber_script.md of
// github.com/google/amber. Its runner is in no Debian package, so this stands in for its parser.
#pragma once

#include <string>
#include <vector>

namespace clipscope::experiments {

struct AmberShader {
  std::string stage, source;  // "vertex", "fragment"
};
struct AmberScript {
  std::string error;  // "line 12: ..."; empty if it is one
  std::vector<AmberShader> shaders;
  int runs = 0, expectations = 0;
};
AmberScript read_amber(const std::string& text);

}  // namespace clipscope::experiments

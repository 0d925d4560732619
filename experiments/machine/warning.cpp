// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/machine/warning.hpp"

#include <fmt/core.h>

#include <cstdio>

namespace clipscope::experiments {

void warn(const std::string& text) { fmt::print(stderr, "clipscope: warning: {}\n", text); }

}  // namespace clipscope::experiments

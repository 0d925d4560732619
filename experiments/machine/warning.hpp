// SPDX-License-Identifier: GPL-3.0-or-later
//
// What people should know though it is no error: a line on standard error.
#pragma once

#include <string>

namespace clipscope::experiments {

// Prints "clipscope: warning: TEXT". Each text once: the experiments of a run load the same mesh
// again and again. May be called from many threads.
void warn(const std::string& text);

}  // namespace clipscope::experiments

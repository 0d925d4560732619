// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the text format of hard cases (tests/corpus/README.md) and checks each against the exact
// reference.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"

namespace clipscope::experiments {

// The cases of a text. Errors: InputError with `file` and line, what was found, what was expected.
std::vector<HardCase> read_cases(const std::string& file, std::string_view text);

}  // namespace clipscope::experiments

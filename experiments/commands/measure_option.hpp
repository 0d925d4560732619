// SPDX-License-Identifier: GPL-3.0-or-later
//
// --measure: of what a hunt wants the worst.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "experiments/hunt/measure.hpp"

namespace clipscope::experiments::commands {

// --measure LIST. usual: what is taken without it.
void add_measure_option(CLI::App& command, std::vector<std::string>& measures,
                        const std::string& usual);

// Errors: UsageError naming those there are.
std::vector<hunt::Measure> measures_of(const std::vector<std::string>& names);

}  // namespace clipscope::experiments::commands

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The catalogue of hard cases: the built-in one, and what a user adds to it.
//
// Cases are written in files NAME.cases; tests/corpus/README.md describes the format. The built-in
// files are part of the program.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"

namespace clipscope::experiments {

// All cases of tests/corpus as they were when the program was built, file by file.
const std::vector<HardCase>& builtin_catalogue();

// The cases of a file, or of all files *.cases of a directory, in the order of their names.
// Errors: InputError naming file and line, what was found and what was expected; also if an expected
// outcome is not the exact one, if two cases have the same name, and if there are none.
std::vector<HardCase> load_catalogue(const std::filesystem::path& path);

// The cases of a text, as if it were a file of that name. Errors: those of load_catalogue.
std::vector<HardCase> parse_catalogue(const std::string& file, std::string_view text);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The README of a results folder: which file answers what.
#pragma once

#include <filesystem>
#include <string>

#include "experiments/store/results_store.hpp"

namespace clipscope::experiments {

// Markdown: how the files are laid out, then a line for each experiment with its question, its
// tables, the one that answers the question first, its plots and its pictures. Errors: InputError
// if the store is damaged.
std::string results_readme(const ResultsStore& store);

// Writes directory/README.md, complete or not at all. Errors: as above; OutputError.
void write_results_readme(const ResultsStore& store, const std::filesystem::path& directory);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a run's results depend on: options, program, machine, files read. A run is resumed only by its like.
#pragma once

#include <filesystem>
#include <string>

#include "experiments/commands/selection.hpp"
#include "experiments/store/results_store.hpp"

namespace clipscope::experiments {

// What `clipscope run` takes where no option says otherwise.
Selection default_run_selection();

// All that is known when a run starts, its date included.
RunInfo run_info_of(const Selection& selection);

// The value of a key; empty if there is none.
std::string value_of(const RunInfo& info, const std::string& key);

// The command that runs the experiment with these options, quoted for a shell. An empty name: all.
std::string run_command(const Selection& selection, const std::string& experiment);

// Errors: UsageError naming every option that differs, and whether program, machine or files do.
void check_resumable(const RunInfo& stored, const RunInfo& now, const std::filesystem::path& file);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands of the program clipscope. Each function adds one to the command line; when the user
// chose it, `action` is what the program then runs, and its result is the exit code (errors.hpp).
#pragma once

#include <functional>
#include <span>
#include <string>

namespace CLI {
class App;
}

namespace clipscope::experiments {
struct Experiment;
}

namespace clipscope::experiments::commands {

using Action = std::function<int()>;

void add_run_command(CLI::App& app, Action& action);
void add_report_command(CLI::App& app, Action& action);
void add_table_command(CLI::App& app, Action& action);
void add_diff_command(CLI::App& app, Action& action);
void add_compare_command(CLI::App& app, Action& action);
void add_verify_command(CLI::App& app, Action& action);
void add_clip_command(CLI::App& app, Action& action);
void add_explain_command(CLI::App& app, Action& action);
void add_bounds_command(CLI::App& app, Action& action);
void add_camera_command(CLI::App& app, Action& action);
void add_render_command(CLI::App& app, Action& action);
void add_plan_command(CLI::App& app, Action& action);
void add_sweep_command(CLI::App& app, Action& action);
void add_merge_command(CLI::App& app, Action& action);
void add_hunt_command(CLI::App& app, Action& action);
void add_promote_command(CLI::App& app, Action& action);
void add_paper_command(CLI::App& app, Action& action);
void add_audit_command(CLI::App& app, Action& action);
void add_list_command(CLI::App& app, Action& action);

// The experiments in the order in which `clipscope run` does them. CMake makes their list from
// CLIPSCOPE_QUESTIONS in experiments/CMakeLists.txt.
std::span<const Experiment* const> all_experiments();

// The whole program, its commands in the order in which its help shows them: the exit code.
int run_program(int argc, char* argv[], const std::string& version);

}  // namespace clipscope::experiments::commands

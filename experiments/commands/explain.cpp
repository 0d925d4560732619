// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope explain: one triangle, step by step.
#include "experiments/commands/commands.hpp"
namespace clipscope::experiments {
void add_explain_command(CLI::App&, Action&) {}
}  // namespace clipscope::experiments

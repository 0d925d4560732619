// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope: where should a triangle be clipped?
#include <fmt/format.h>

#include "experiments/commands/commands.hpp"
#include "experiments/machine/build_info.hpp"

int main(int argc, char* argv[]) {
  using namespace clipscope::experiments;
  using namespace clipscope::experiments::commands;
  return run_program(argc, argv, fmt::format("clipscope {} ({})", kVersion, kCommit));
}

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Options that bring clippers of the user's: guests, which then compete under their own names.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/guests/plugin.hpp"
#include "experiments/selection/select.hpp"

namespace clipscope::experiments::commands {

struct GuestOptions {
  std::vector<std::string> plugins, programs;
  std::vector<std::string> takes;  // what the programs take
  std::string space;               // of these; empty: clip, or as `takes` says
  std::string name;                // of the only program
  std::optional<double> seconds;   // that a batch may take
};

// --plugin LIB and --program COMMAND, as often as wanted, and what these need: --time-limit,
// --takes and --name.
void add_guest_options(CLI::App& command, GuestOptions& options);
// --space of programs, where it does not say what space the command's input is in.
void add_guest_space_option(CLI::App& command, GuestOptions& options);

// The options that bring them, as a command has them: " --plugin ./libmine.so"; empty for none.
std::string command_options(const GuestOptions& options);

// Their names, plug-ins first, in the order given. Errors: GuestError, UsageError.
std::vector<std::string_view> load_guests(const GuestOptions& options);
// The same for commands that compare clippers. Errors: UsageError, too, if a guest computes in none
// of the scalars selected.
void load_guests(const GuestOptions& options, Selection& selection);
// Errors: UsageError if a guest that clips triangles does not take those of scenes.
void check_takes_scenes(const Selection& selection);

// The clipper of a command that takes one: the one named, or else the only guest, or else the usual
// one. Errors: UsageError if several guests were brought and none is named, or there is nothing.
std::string given_clipper(const std::string& clipper, const std::vector<std::string_view>& guests,
                          std::string_view usual = "");

}  // namespace clipscope::experiments::commands

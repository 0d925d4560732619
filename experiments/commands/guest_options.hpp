// SPDX-License-Identifier: GPL-3.0-or-later
//
// Options that bring clippers of the user's: guests, which then compete under their own names.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/guests/plugin.hpp"
#include "experiments/selection/select.hpp"

namespace clipscope::experiments::commands {

struct GuestOptions {
  std::vector<std::string> plugins;
  double seconds = kPluginSeconds;  // that a batch may take
};

// --plugin LIB, as often as wanted, and --time-limit.
void add_guest_options(CLI::App& command, GuestOptions& options);

// Their names, in the order given. Errors: GuestError.
std::vector<std::string_view> load_guests(const GuestOptions& options);
// The same for commands that compare clippers. Errors: UsageError, too, if a guest computes in none
// of the scalars selected.
void load_guests(const GuestOptions& options, Selection& selection);
// Errors: UsageError if a guest that clips triangles does not take those of scenes.
void check_takes_scenes(const Selection& selection);

// The clipper of a command that takes one: the one given or else the first guest. Errors:
// UsageError if there is neither.
std::string given_clipper(const std::string& clipper, const std::vector<std::string_view>& guests);

}  // namespace clipscope::experiments::commands

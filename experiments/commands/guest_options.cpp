// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/commands/guest_options.hpp"

#include "experiments/commands/options.hpp"

namespace clipscope::experiments::commands {

void add_guest_options(CLI::App& command, GuestOptions& options) {
  add_option(
      command, "--plugin", options.plugins, "LIB",
      "A clipper of yours: a shared library with the interface of clipscope_plugin.h; may be given several times")
      ->allow_extra_args(false);
  add_option(command, "--time-limit", options.seconds, "SECONDS",
             fmt::format("What a plug-in may take for a batch [{:g}]", options.seconds))
      ->check(CLI::Range(0.01, 86400.0));
}

std::vector<std::string_view> load_guests(const GuestOptions& options) {
  std::vector<std::string_view> names;
  for (const std::string& library : options.plugins) {
    names.push_back(add_plugin(library, options.seconds));
  }
  return names;
}

void load_guests(const GuestOptions& options, Selection& selection) {
  selection.guests = load_guests(options);
  selection.guest_files = options.plugins;
  check_scalars_of_guests(selection);
}

std::string given_clipper(const std::string& clipper, const std::vector<std::string_view>& guests) {
  if (!clipper.empty()) return clipper;
  if (guests.empty()) usage_error("--clipper: a clipper's name is missing, or --plugin with yours");
  return std::string(guests.front());
}

}  // namespace clipscope::experiments::commands

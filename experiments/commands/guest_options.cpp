// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/commands/guest_options.hpp"

#include "experiments/commands/options.hpp"
#include "experiments/selection/replay_text.hpp"

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

void check_takes_scenes(const Selection& selection) {
  const DepthRange depth = selection.camera.depth;
  const Batch batch{.space = Space::view,
                    .frustum = {.depth = depth},
                    .volume = {.depth = depth},
                    .attributes = kSceneAttributes};
  for (const std::string_view guest : selection.guests) {
    for (const Contestant& c : all_contestants()) {
      if (c.clipper != guest || c.vertices != 3 || c.takes(batch)) continue;
      usage_error(
          "{}: {} does not take what scenes are made of: triangles with {} attributes in view space or clip space, --depth {}",
          c.brought_by, guest, kSceneAttributes, depth_option(depth));
    }
  }
}

std::string given_clipper(const std::string& clipper, const std::vector<std::string_view>& guests) {
  if (!clipper.empty()) return clipper;
  if (guests.empty()) usage_error("--clipper: a clipper's name is missing, or --plugin with yours");
  return std::string(guests.front());
}

}  // namespace clipscope::experiments::commands

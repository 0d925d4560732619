// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/commands/volume_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "experiments/commands/number_list.hpp"

namespace clipscope::experiments {
namespace {

void add_plane(VolumeOptions& options, const std::vector<double>& numbers) {
  for (const double x : numbers) {
    if (!std::isfinite(x)) {
      throw CLI::ValidationError("--plane", fmt::format("{} given, finite numbers expected", x));
    }
  }
  std::copy_n(numbers.begin(), 4, options.planes.emplace_back().begin());
}

}  // namespace

void add_volume_options(CLI::App& command, VolumeOptions& options) {
  command
      .add_option("--clip-distances", options.clip_distances,
                  "The first N attributes are clip distances: inside is >= 0 [0]")
      ->type_name("N")
      ->check(CLI::Range(0, kMaxClipDistances));
  command.add_flag("--depth-clamp", options.depth_clamp, "The near and far planes do not clip");
  add_number_list(
      command, "--plane", 4, "A,B,C,D",
      [&options](const std::vector<double>& numbers) { add_plane(options, numbers); },
      "User clip plane in the space of the input: inside is A x + B y + C z + D >= 0, in clip "
      "space "
      "with D w; may be given again")
      ->trigger_on_parse();
}

ClipVolume volume_of(const VolumeOptions& options, DepthRange depth, int attributes) {
  const int planes = static_cast<int>(options.planes.size());
  if (options.clip_distances > attributes) {
    throw UsageError(
        fmt::format("--clip-distances: {} asked for, but --attributes gives {} per vertex",
                    options.clip_distances, attributes));
  }
  if (planes + options.clip_distances > kMaxClipDistances) {
    throw UsageError(
        fmt::format("--plane: planes ({}) and clip distances ({}) are more than {} in all", planes,
                    options.clip_distances, kMaxClipDistances));
  }
  if (planes + attributes > kMaxAttributes) {
    throw UsageError(fmt::format("--plane: planes ({}) and attributes ({}) are more than {} in all",
                                 planes, attributes, kMaxAttributes));
  }
  return {depth, options.depth_clamp, planes + options.clip_distances};
}

void check_applicable(std::string_view clipper, const Promise& promise, const ClipVolume& volume) {
  if (is_applicable(promise, volume)) return;
  const bool depth_clamp = volume.depth_clamp && !promise.depth_clamp;
  throw UsageError(fmt::format("--clipper: {} does not take {}", clipper,
                               depth_clamp ? "--depth-clamp" : "--clip-distances and --plane"));
}

}  // namespace clipscope::experiments

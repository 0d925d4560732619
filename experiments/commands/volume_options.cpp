// SPDX-License-Identifier: GPL-3.0-or-later
//
// The options that say which kind of primitive is clipped, and what clips it beside a projection.
#include <cmath>

#include "experiments/commands/options.hpp"
#include "experiments/selection/replay_text.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments::commands {
namespace {

// Errors: UsageError if there are more clip distances than attributes, or more of either than fit.
void check_counts(const VolumeOptions& options, int attributes) {
  const int planes = static_cast<int>(options.planes.size());
  const int distances = options.clip_distances;
  if (distances > attributes) {
    usage_error("--clip-distances: {} asked for, but --attributes gives {} per vertex", distances,
                attributes);
  }
  if (planes + distances > kMaxClipDistances) {
    usage_error("--plane: planes ({}) and clip distances ({}) are more than {} in all", planes,
                distances, kMaxClipDistances);
  }
  if (planes + attributes > kMaxAttributes) {
    usage_error("--plane: planes ({}) and attributes ({}) are more than {} in all", planes,
                attributes, kMaxAttributes);
  }
}

// Errors: CLI::ValidationError.
std::array<double, 4> parse_plane(const std::vector<double>& numbers) {
  for (const double x : numbers) {
    if (std::isfinite(x)) continue;
    throw CLI::ValidationError("--plane", fmt::format("{} given, finite numbers expected", x));
  }
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

// A flag that may say which plane: --depth-clamp, --depth-clamp=near.
void add_depth_clamp_option(CLI::App& command, DepthClamp& clamp) {
  const auto set = [&clamp](const std::string& planes) {
    clamp = {planes != "far", planes != "near"};
  };
  const std::string help =
      "The near and far planes do not clip; with =near or =far that one alone does not";
  command.add_flag("--depth-clamp{both}", help)
      ->check(CLI::IsMember({"near", "far", "both"}))
      ->each(set);
}

// A flag that may say which sides: --half-open, --half-open=right,top.
void add_half_open_option(CLI::App& command, OpenSides& open) {
  const auto set = [&open](const std::string& sides) {
    open = sides == "top-left";
    if (open) return;
    for (const std::string& side : CLI::detail::split(sides, ',')) {
      bool* const is_open = find_side(open, side);
      if (is_open == nullptr) {
        throw CLI::ValidationError(
            "--half-open",
            fmt::format("'{}' given, some of left, right, bottom and top expected", side));
      }
      *is_open = true;
    }
  };
  const std::string help =
      "The right and bottom sides do not own what lies in them (top-left rule): of tiles side by side one alone answers it. With =right,top or other sides these do not";
  command.add_flag("--half-open{top-left}", help)->each(set);
}

}  // namespace

void add_primitive_option(CLI::App& command, Primitive& primitive) {
  const auto set = [&primitive](const std::string& name) {
    primitive = CellOf<Primitive>::read(name);
  };
  command
      .add_option_function<std::string>(
          "--primitive", set, "What a line holds: triangle, segment, point or polygon [triangle]")
      ->check(CLI::IsMember({"triangle", "segment", "point", "polygon"}));
}

void add_boundary_options(CLI::App& command, VolumeOptions& options) {
  add_option(command, "--clip-distances", options.clip_distances, "N",
             "The first N attributes are clip distances: inside is >= 0 [0]")
      ->check(CLI::Range(0, kMaxClipDistances));
  add_depth_clamp_option(command, options.depth_clamp);
  add_half_open_option(command, options.open_sides);
}

void add_volume_options(CLI::App& command, VolumeOptions& options) {
  add_boundary_options(command, options);
  const auto add = [&options](const std::vector<double>& numbers) {
    options.planes.push_back(parse_plane(numbers));
  };
  add_number_list(
      command, "--plane", 4, "A,B,C,D", add,
      "User clip plane in the space of the input: inside is A x + B y + C z + D >= 0, in clip space with D w; may be given again")
      ->trigger_on_parse();
}

bool is_finite_in(const Format& format, double x) {
  return std::isfinite(format.is_float() ? static_cast<float>(x) : x);
}

void set_volume(const VolumeOptions& options, const Format& format, Batch& batch) {
  check_counts(options, batch.attributes);
  for (const std::array<double, 4>& plane : options.planes) {
    for (const double x : plane) {
      if (is_finite_in(format, x)) continue;
      usage_error("--plane: {} is not finite in {}; expected finite numbers", x, format.name);
    }
  }
  batch.volume.depth_clamp = options.depth_clamp;
  batch.volume.open_sides = options.open_sides;
  batch.volume.clip_distances = options.clip_distances;
  batch.planes = options.planes;
}

namespace {

// Pre-condition: something of the batch is not, but its space and its matrix are.
std::string not_taken(const Contestant& contestant, const Batch& batch) {
  const ClipVolume& volume = batch.volume;
  const Promise& promise = contestant.promise;
  if (volume.depth_clamp && !promise.depth_clamp) return "--depth-clamp";
  if (volume.open_sides && !promise.open_sides) return "--half-open";
  if ((volume.clip_distances > 0 || !batch.planes.empty()) && !promise.clip_distances) {
    return "--clip-distances and --plane";
  }
  if (!contestant.depths[static_cast<std::size_t>(volume.depth)]) {
    return fmt::format("--depth {}", depth_option(volume.depth));
  }
  const int distances = volume.clip_distances + static_cast<int>(batch.planes.size());
  if (distances > contestant.most_attributes) {
    return fmt::format("{} clip distances and planes, for it takes {} attributes at most",
                       distances, contestant.most_attributes);
  }
  return "such a frustum";
}

}  // namespace

void check_takes(const Contestant& contestant, const Batch& batch) {
  if (contestant.takes(batch)) return;
  if (batch.space == Space::clip && !contestant.takes_clip_space) {
    usage_error("--clipper: {} starts in view space, so clip-space coordinates are not applicable",
                contestant.clipper);
  }
  if (batch.matrix && !contestant.takes_clip_space) {
    usage_error(
        "--clipper: {} cuts against the planes of a frustum, so a --matrix is not applicable; take one that starts in clip space, such as homogeneous/sutherland_hodgman",
        contestant.clipper);
  }
  if (contestant.is_guest) {
    usage_error("{}: {} does not take {}", contestant.brought_by, contestant.clipper,
                not_taken(contestant, batch));
  }
  usage_error("--clipper: {} does not take {}", contestant.clipper, not_taken(contestant, batch));
}

}  // namespace clipscope::experiments::commands

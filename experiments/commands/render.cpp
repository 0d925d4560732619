// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope render: a picture of a scene with a clipper, and its error beside it.
#include <optional>

#include "experiments/commands/guest_options.hpp"
#include "experiments/commands/options.hpp"
#include "experiments/render/figure.hpp"
#include "experiments/survey/draw_scene.hpp"

namespace clipscope::experiments::commands {
namespace {

struct RenderOptions {
  Selection selection;
  GuestOptions guests;
  std::string scene, scalar = "float", view, against, out;
  double cells = 8;
  PictureSize size;
};

void print_counts(const HeatMapCounts& counts) {
  fmt::print("{} pixels drawn by both: largest error {:.3g} texels of 1024, median {:.3g}\n",
             counts.compared(), counts.max_error, counts.median_error);
  fmt::print("holes {}, extra {}, flipped {}, not finite {} px\n", counts[PixelFate::hole],
             counts[PixelFate::extra], counts[PixelFate::flipped], counts[PixelFate::not_finite]);
}

PictureSize picture_size(const std::vector<double>& size) {
  for (const double length : size) {
    if (!(length >= 16 && length <= 16384)) {
      throw CLI::ValidationError("--size", fmt::format("{} given, 16 to 16384 expected", length));
    }
  }
  return {static_cast<int>(size[0]), static_cast<int>(size[1])};
}

int render(const RenderOptions& options) {
  check_image_path(options.out);
  const std::vector<std::string_view> guests = load_guests(options.guests);
  const Contestant& contestant =
      find_contestant(given_clipper(options.selection.clipper, guests), options.scalar);
  const Scene scene = load_selected_scene(options.selection, options.scene);
  const View& view = find_view(scene, options.view);
  const FrameBuffer tested = draw_with(contestant, scene, view, options.size);
  const std::string title = fmt::format("{}, {}", scene.name, view.label);
  Figure figure{&tested,
                nullptr,
                {title, std::string(contestant.clipper), options.scalar, "exact"},
                {.cells_per_unit = options.cells}};
  std::optional<HeatMap> heat_map;
  if (!options.against.empty()) {
    heat_map = compare(tested, draw_exact(scene, view, options.size));
    figure.heat_map = &*heat_map;
    print_counts(heat_map->counts);
  }
  write_image(options.out, figure);
  fmt::print("written: {}\n", options.out);
  return kExitOk;
}

}  // namespace

void add_render_command(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(
      app, action, render, "render", "Draw a scene with a clipper, and its error",
      R"(PNG: the figure, with legend. EXR: picture, depth, texture coordinates, error and more as float
channels.)");
  add_scene_options(command, options.selection);
  command.remove_option(command.get_option("--scene"));
  add_option(command, "--scene", options.scene, "NAME|FILE", "A built-in scene or a mesh file")
      ->required();
  command.add_option("--view", options.view, "Label of the scene's view [the first]");
  add_contestant_options(command, options.selection.clipper, options.scalar);
  add_guest_options(command, options.guests);
  add_guest_space_option(command, options.guests);
  command.add_option("--against", options.against, "Also show the error against this")
      ->check(CLI::IsMember({"exact"}));
  command.add_option("--cells", options.cells, "Checkerboard cells per unit of u and v [8]");
  add_number_list(
      command, "--size", 2, "W,H",
      [&to = options.size](const std::vector<double>& size) { to = picture_size(size); },
      "Width and height in pixels [960,540]");
  add_option(command, "--out", options.out, "FILE", "Where to write: FILE.png or FILE.exr")
      ->required();
}

}  // namespace clipscope::experiments::commands

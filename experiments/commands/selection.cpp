// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/commands/selection.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "experiments/commands/number_list.hpp"
#include "experiments/scenes/builtin.hpp"

namespace clipscope::experiments {
namespace {

CLI::Option* add_vector_option(CLI::App& command, const std::string& name,
                               std::optional<glm::dvec3>& value, const std::string& help) {
  return add_number_list(
      command, name, 3, "X,Y,Z",
      [&value](const std::vector<double>& v) { value = glm::dvec3(v[0], v[1], v[2]); }, help);
}

void add_camera_options(CLI::App& command, CameraOptions& camera) {
  const std::string group = "Camera (without --eye: a walk around and through the mesh)";
  add_vector_option(command, "--eye", camera.eye, "Where the camera is")->group(group);
  add_vector_option(command, "--target", camera.target, "What it looks at [centre of the mesh]")
      ->group(group);
  add_vector_option(command, "--up", camera.up, "Which way is up [0,1,0]")->group(group);
  command.add_option("--fovy", camera.fovy_degrees, "Vertical angle of view in degrees [60]")
      ->group(group);
  command.add_option("--aspect", camera.aspect, "Width over height of the picture [16:9]")
      ->group(group);
  command.add_option("--near", camera.near, "Distance of the near plane [from the mesh]")
      ->group(group);
  command.add_option("--far", camera.far, "Distance of the far plane [from the mesh]")
      ->group(group);
  command.add_option("--walk", camera.walk, "Number of camera positions of the walk [6]")
      ->group(group);
}

}  // namespace

void add_scene_options(CLI::App& command, Selection& selection) {
  command
      .add_option("--scene", selection.scenes,
                  "A built-in scene (see `clipscope list scenes`) or a mesh file (OBJ, PLY, STL, "
                  "glTF); may be repeated [all built-in scenes]")
      ->type_name("NAME|FILE")
      ->allow_extra_args(false);
  command.add_option("--seed", selection.seed, "Seed of the random scenes [1]");
  command.add_option("--sample", selection.sample,
                     "At most this many triangles per view, evenly spaced; 0: all");
  command.add_flag("--quick", selection.quick, "Smaller scenes, for a first look");
  add_camera_options(command, selection.camera);
}

void add_contestant_options(CLI::App& command, Selection& selection) {
  command
      .add_option("--clipper", selection.clipper,
                  "Shell pattern of clipper names, such as 'cvv/*' (see `clipscope list clippers`)")
      ->type_name("GLOB");
  command
      .add_option("--scalar", selection.scalars,
                  fmt::format("Scalars, separated by commas (see `clipscope list scalars`) [{}]",
                              fmt::join(selection.scalars, ",")))
      ->type_name("LIST")
      ->delimiter(',')
      ->allow_extra_args(false);
}

void add_json_option(CLI::App& command, Selection& selection) {
  command.add_flag("--json", selection.json, "Print JSON (run: one table per line)");
}

std::vector<std::string> scene_names(const Selection& selection) {
  if (!selection.scenes.empty()) return selection.scenes;
  std::vector<std::string> names;
  for (const SceneInfo& info : builtin_scenes()) names.emplace_back(info.name);
  return names;
}

Scene load_selected_scene(const Selection& selection, const std::string& name) {
  const SceneOptions options{.seed = selection.seed, .quick = selection.quick};
  return load_scene(name, options, selection.camera);
}

std::vector<AnyContestant> selected_contestants(const Selection& selection) {
  return select_contestants(selection.clipper, selection.scalars);
}

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The options that commands share: which scenes, cameras, clippers and scalars.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "experiments/scenes/camera.hpp"
#include "experiments/scenes/scene.hpp"

namespace CLI {
class App;
}

namespace clipscope::experiments {

struct Selection {
  std::vector<std::string> scenes;  // empty: all built-in ones
  CameraOptions camera;
  std::string clipper = "*";
  std::vector<std::string> scalars = {"float", "double"};
  std::uint64_t seed = 1;
  std::size_t sample = 0;  // triangles per view; 0: the command's default
  bool quick = false;
  bool json = false;
  bool pictures = false;  // also those of single cases that fail
};

// --scene, --seed, --quick, --sample and the camera.
void add_scene_options(CLI::App& command, Selection& selection);

// --clipper GLOB and --scalar LIST.
void add_contestant_options(CLI::App& command, Selection& selection);

void add_json_option(CLI::App& command, Selection& selection);

// Names or files, all built-in scenes if none was given.
std::vector<std::string> scene_names(const Selection& selection);

// Errors: InputError, UsageError.
Scene load_selected_scene(const Selection& selection, const std::string& name);

std::vector<AnyContestant> selected_contestants(const Selection& selection);

}  // namespace clipscope::experiments

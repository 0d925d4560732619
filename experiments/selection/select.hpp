// SPDX-License-Identifier: GPL-3.0-or-later
//
// What was chosen: scenes, cameras, clippers and scalars; contestants by name.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "experiments/scenes/camera.hpp"
#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

// The names of all clippers of primitives with so many vertices (0: polygons) under the full
// contract, in the order of spaces/clippers.hpp; and of all scalars.
std::vector<std::string_view> clipper_names(int vertices = 3);
std::vector<std::string_view> scalar_names();

// The contestants of the full contract whose clipper matches the shell pattern (`*`, `?`; a name
// without them also stands for the clippers of which it is the folder or the method) and whose
// scalar is in the list, by clipper, then scalar; a clipper that there is not in a scalar is left
// out. A seeded bug (guests/seeded.hpp) is meant by its whole name alone. Throws UsageError naming
// the option, what was given and what there is.
Contestants select_contestants(std::string_view clipper_pattern,
                               const std::vector<std::string>& scalars, int vertices = 3);

// The one contestant of that name, maybe a seeded bug. Throws UsageError if none or several match.
const Contestant& find_contestant(std::string_view clipper, std::string_view scalar,
                                  int vertices = 3);

// The one with that clipper and scalar under that contract; null if there is none.
const Contestant* find_in_contract(std::string_view clipper, std::string_view scalar,
                                   Contract contract, int vertices = 3);

// Whether a contestant's clipper is among those of the list, in whatever scalar and contract.
bool has_clipper(const Contestants& contestants, std::string_view clipper);

// The contestants of all stage contracts that the input has a layout for, the baseline `textbook`
// first.
Contestants stage_contestants(const StageInput& input);

// Of the batch clippers those that there are in a stage alone, whose name matches the pattern as in
// select_contestants; in any contract and build.
Contestants stage_only_contestants(std::string_view clipper_pattern);

struct Selection {
  std::vector<std::string> scenes;  // empty: all built-in ones
  CameraOptions camera;
  std::string clipper = "*";
  std::vector<std::string_view> guests;  // clippers that the user brought, in the order given
  std::vector<std::string> guest_files;  // what they are in
  std::vector<std::string> scalars = {"float", "double"};
  std::uint64_t seed = 1;
  std::size_t sample = 0;  // triangles per view; 0: the command's default
  bool quick = false;
  bool recentre = false;  // see recentre.hpp
  bool json = false;
  bool tables = false;    // run: print every table
  bool pictures = false;  // also those of single cases that fail
  bool realtime = false;  // threads that measure are in the real-time class; see measuring.hpp

  // What was asked for, or what an experiment takes without.
  std::vector<std::string> scenes_or(std::vector<std::string> usual) const {
    return scenes.empty() ? std::move(usual) : scenes;
  }
  std::size_t sample_or(std::size_t in_quick, std::size_t in_full) const {
    if (sample != 0) return sample;
    return quick ? in_quick : in_full;
  }
};

// Names or files, all built-in scenes if none was given.
std::vector<std::string> scene_names(const Selection& selection);

// Warns of what a mesh file has that people should know, and of detail that float loses.
// Errors: InputError, UsageError.
Scene load_selected_scene(const Selection& selection, const std::string& name);

// Those of --clipper, and the guests, in the scalars selected. Errors: UsageError.
Contestants selected_contestants(const Selection& selection, int vertices = 3);
// The same in other scalars.
Contestants select_contestants(const Selection& selection, const std::vector<std::string>& scalars,
                               int vertices = 3);

// Errors: UsageError if a guest computes in none of the scalars selected.
void check_scalars_of_guests(const Selection& selection);

// The clippers of the names in the scalars selected, or those of --clipper where it was given: for
// an experiment that shows a few clippers unless others are asked for. Guests are always among
// them. Errors: UsageError.
Contestants named_contestants(const Selection& selection, std::span<const std::string_view> names);

}  // namespace clipscope::experiments

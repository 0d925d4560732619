// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a driver is audited with: the draw calls of the catalogue, of lattices of small numbers, of
// chance and of scenes.
//
// The same options and the same driver make the same draw calls in the same order, and a greater
// number of a kind begins with those of a smaller one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "experiments/drawcalls/driver.hpp"

namespace clipscope::experiments {

struct WorkloadOptions {
  std::size_t lattice = 5000;  // draw calls of small numbers; from kLatticeStrata on all strata
  std::size_t random = 1000;   // draw calls of chance
  int size = 0;                // of all targets, px; 0: 32 and, of some, 256
  std::uint64_t seed = 1;
  bool catalogue = true, scenes = true;  // scenes: the built-in ones
  // Another scene: a mesh file in which a camera walks, or a built-in one by name; empty: none.
  std::string scene = {};
  std::filesystem::path cases = {};  // a corpus file, or a folder of them; empty: none
};

// How many draw calls were left out, by what the driver says of itself: "has no depth clamp".
using LeftOut = std::map<std::string, std::size_t>;

// Calls f with each draw call that the driver can do. Errors: those of load_catalogue and
// load_scene.
LeftOut for_each_draw_call(const WorkloadOptions& options, const DriverInfo& info,
                           const std::function<void(const DrawCall&)>& f);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The scenes that clipscope ships: small, seeded, and made of code alone.
//
// A scene is the same bit for bit for the same options. The name list of `builtin_scenes()` is the
// order in which they are shown. To add one: write its family's .cpp, declare it in families.hpp and
// add its line to the table in builtin.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "experiments/scenes/scene.hpp"
#include "experiments/scenes/soup.hpp"

namespace clipscope::experiments {

struct SceneOptions {
  std::uint64_t seed = 1;  // of the scenes that are random
  bool quick = false;      // about a quarter of the triangles
};

struct SceneInfo {
  std::string_view name, description;
};

std::span<const SceneInfo> builtin_scenes();

bool is_builtin_scene(std::string_view name);

// Errors: UsageError for an unknown name, listing the known ones.
Scene make_builtin_scene(std::string_view name, const SceneOptions& options);

}  // namespace clipscope::experiments

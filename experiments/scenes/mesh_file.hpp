// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangle meshes from OBJ, PLY, STL and glTF (.gltf, .glb) files, through the Open Asset Import
// Library (assimp).
#pragma once

#include <filesystem>

#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

Mesh load_mesh(const std::filesystem::path& path);

}  // namespace clipscope::experiments

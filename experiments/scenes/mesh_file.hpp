// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangle meshes from OBJ, PLY, STL and glTF (.gltf, .glb) files, through the Open Asset Import
// Library (assimp).
//
// assimp is lenient: it reads some broken files as smaller or emptier ones, and may crash on others.
// So every file is checked first (mesh_checks.hpp), and assimp sees only files that are sound.
#pragma once

#include <filesystem>

#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

// The triangles of all meshes in the file, node transforms applied, in the file's order. Polygons are
// triangulated, points and lines skipped; coordinates are otherwise kept as the file has them (but in
// OBJ and text PLY a number with an exponent may come out one float off, which is assimp's conversion), and
// vertices are merged only where all their bits agree.
// Attributes: the file's first texture coordinates, or else the position within the bounding box along
// its two longest axes, in [0, 1]; and the unit normal's x and y if the file has normals per vertex
// (OBJ, PLY, glTF), or else the position within the box along its longest and its shortest axis, in
// [-1, 1]. Where only some of a file's meshes have them, each mesh is treated by itself.
// Memory: a few hundred bytes per triangle at the peak.
// Errors: InputError naming the file and the line or element for anything that is missing, truncated
// or out of range, for coordinates that are not finite, and for a file without triangles.
Mesh load_mesh(const std::filesystem::path& path);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangle meshes from OBJ, PLY, STL and glTF (.gltf, .glb) files.
//
// Every number is rounded once: from its decimal text or its bits to float, and beside that to
// double where some position is no float. The readers are strict in what is used and in the
// structure of a file, and skip what has no part in the polygons unread.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

// The triangles of all meshes in the file, in the file's order: of glTF those that the default
// scene shows, node transforms applied in double. Points and lines are skipped. Vertices are
// merged only where all their bits agree, in double where there are doubles.
// Polygons of more than three corners: a convex quadrangle is cut from its first corner, others by
// a constrained Delaunay triangulation of their projection (triangulate.hpp), also those that are
// not flat. One that crosses or touches itself or has no area becomes a fan around its first
// corner, and a remark counts them.
// Attributes: the file's first texture coordinates, or else the position within the bounding box
// along its two longest axes, in [0, 1]; and the unit normal's x and y if the file has normals per
// vertex (OBJ, PLY, glTF), or else the position within the box along its longest and its shortest
// axis, in [-1, 1]. Where only some of a file's vertices have them, each is treated by itself.
// Memory: the file, and some 100 bytes per vertex and 30 per triangle.
// Errors: InputError naming the file and the line or element for anything that is missing,
// truncated or out of range, for used coordinates that are not finite or that no float can hold,
// for words that the format does not know, and for a file without triangles.
Mesh load_mesh(const std::filesystem::path& path);

// The readers. `name` is the file's path, `content` all of it. Errors as above.
Mesh read_obj(const std::string& name, std::string_view content);
Mesh read_ply(const std::string& name, std::string_view content);
Mesh read_stl(const std::string& name, std::string_view content);
Mesh read_gltf_mesh(const std::string& name, std::string_view content);

}  // namespace clipscope::experiments

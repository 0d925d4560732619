// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangle meshes from OBJ, PLY, STL and glTF (.gltf, .glb) files, through the Open Asset Import
// Library (assimp).
//
// assimp is lenient: it reads some broken files as smaller or emptier ones, and may crash on
// others. So every file is checked first, and assimp sees only files that are sound.
#pragma once

#include <filesystem>
#include <string>

#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

// The triangles of all meshes in the file, node transforms applied, in the file's order. Polygons
// are triangulated, points and lines skipped; coordinates are otherwise kept as the file has them
// (but in OBJ and text PLY a number with an exponent may come out one float off, which is assimp's
// conversion), and vertices are merged only where all their bits agree.
// Attributes: the file's first texture coordinates, or else the position within the bounding box
// along its two longest axes, in [0, 1]; and the unit normal's x and y if the file has normals per
// vertex (OBJ, PLY, glTF), or else the position within the box along its longest and its shortest
// axis, in [-1, 1]. Where only some of a file's meshes have them, each mesh is treated by itself.
// Memory: a few hundred bytes per triangle at the peak.
// Errors: InputError naming the file and the line or element for anything that is missing,
// truncated or out of range, for coordinates that are not finite, and for a file without triangles.
Mesh load_mesh(const std::filesystem::path& path);

// The checks. A file that passes has all the data that it announces, indices that point at existing
// vertices and coordinates that a float can hold. Keywords, elements and properties that do not
// concern geometry are skipped unread. Each check throws InputError at the first offence: the file,
// the line (text) or the element (binary), what was found and what would be right.
// `name` is the file's path, `content` all of it. The result is what assimp gets to read:
// PLY as it is,
std::string geometry_of_ply(const std::string& name, std::string content);
// STL in its binary form,
std::string geometry_of_stl(const std::string& name, std::string content);
// vertices, texture coordinates, normals and faces of an OBJ file alone, one plain line each, since
// assimp knows no comments behind a face,
std::string geometry_of_obj(const std::string& name, std::string content);
// and glTF as a binary file of one buffer with the geometry of the default scene, which includes
// the buffers that lie in other files. Materials, animations, skins, cameras and extensions are
// left out.
std::string geometry_of_gltf(const std::string& name, std::string content);

}  // namespace clipscope::experiments

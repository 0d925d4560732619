// SPDX-License-Identifier: GPL-3.0-or-later
//
// From assimp's scene graph to one flat mesh.
#pragma once

#include <string>

#include "experiments/scenes/scene.hpp"

struct aiScene;

namespace clipscope::experiments {

// Errors: InputError if a face refers to a vertex that its mesh has not.
void require_valid_indices(const std::string& name, const aiScene& scene);

// All triangles of all nodes in world space, with the attributes that `load_mesh` documents. Normals
// are used if `has_vertex_normals`: those of STL are the facets'.
// Errors: InputError if a position or an attribute is not finite.
// Pre-condition: the indices are valid.
Mesh flatten(const std::string& name, const aiScene& scene, bool has_vertex_normals);

// Merges vertices whose positions and attributes agree in every bit, and drops those that no triangle
// uses. Triangles keep their order and corners.
void merge_equal_vertices(Mesh& mesh);

}  // namespace clipscope::experiments

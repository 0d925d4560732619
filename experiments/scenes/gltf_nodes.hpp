// SPDX-License-Identifier: GPL-3.0-or-later
//
// The node tree of a glTF file: which nodes are shown, and where each stands.
//
// Source: Khronos Group, "glTF 2.0 Specification", 2021, section 3.5. Matrices are multiplied in
// double; a rotation's quaternion is scaled to length 1 first, since files hold it in float.
#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "experiments/scenes/gltf.hpp"

namespace clipscope::experiments {

// The rotation by a quaternion x, y, z, w. Pre-condition: it is not 0.
glm::dmat4 rotation_matrix(const glm::dvec4& quaternion);

struct GltfNode {
  std::size_t index;  // into the file's nodes
  glm::dmat4 world_from_node;
};

// All nodes of the default scene, or of the first one where none is the default, or of the whole
// file where it has no scene: each parent before its children, otherwise in the file's order.
// Errors: InputError for a node that has two parents, for a loop, and for a transform that is no
// list of finite numbers or a rotation of length 0.
std::vector<GltfNode> shown_nodes(const Gltf& gltf);

}  // namespace clipscope::experiments

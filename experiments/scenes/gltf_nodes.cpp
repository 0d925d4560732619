// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/gltf_nodes.hpp"

#include <cmath>

namespace clipscope::experiments {
namespace {

using Children = std::vector<std::vector<std::size_t>>;  // of each node

glm::dmat4 rotation_of(const GltfValue& rotation) {
  const std::vector<double> q = rotation.numbers(4);
  const glm::dvec4 quaternion(q[0], q[1], q[2], q[3]);
  if (quaternion == glm::dvec4(0)) rotation.fail("has length 0; a quaternion of length 1 expected");
  return rotation_matrix(quaternion);
}

// The matrix, or else translation * rotation * scale; the identity where the node has none.
glm::dmat4 transform_of(const GltfValue& node) {
  glm::dmat4 m(1.0);
  if (const GltfValue matrix = node["matrix"]) {
    const std::vector<double> v = matrix.numbers(16);
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = v[static_cast<std::size_t>(i)];
    return m;
  }
  if (const GltfValue rotation = node["rotation"]) m = rotation_of(rotation);
  if (const GltfValue scale = node["scale"]) {
    const std::vector<double> s = scale.numbers(3);
    for (int i = 0; i < 3; ++i) m[i] *= s[static_cast<std::size_t>(i)];
  }
  if (const GltfValue translation = node["translation"]) {
    const std::vector<double> t = translation.numbers(3);
    m[3] = {t[0], t[1], t[2], 1};
  }
  return m;
}

std::vector<bool> mark_children(const Gltf& gltf, const Children& children) {
  std::vector<bool> is_child(children.size(), false);
  for (const std::vector<std::size_t>& list : children) {
    for (const std::size_t child : list) {
      if (is_child[child]) refuse(gltf.name, "nodes[{}] is the child of two nodes", child);
      is_child[child] = true;
    }
  }
  return is_child;
}

// The roots that are shown. With at most one parent for each node and roots without any, what hangs
// from a root is a tree.
std::vector<std::size_t> roots_of(const Gltf& gltf, const Children& children) {
  std::vector<bool> seen = mark_children(gltf, children);
  std::vector<std::size_t> roots;
  const GltfValue scenes = gltf["scenes"], scene = gltf["scene"];
  if (scenes.size() > 0) {
    const std::size_t shown = scene ? scene.index_into("scenes") : 0;
    roots = scenes.object_at(shown)["nodes"].indices_into("nodes");
  } else {
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (!seen[i]) roots.push_back(i);
    }
  }
  for (const std::size_t root : roots) {
    if (seen[root] && scenes.size() > 0) {
      refuse(gltf.name, "nodes[{}] is a root of the scene and appears a second time", root);
    }
    seen[root] = true;
  }
  return roots;
}

}  // namespace

glm::dmat4 rotation_matrix(const glm::dvec4& q) {
  const double length = std::hypot(std::hypot(q.x, q.y), std::hypot(q.z, q.w));
  const double x = q.x / length, y = q.y / length, z = q.z / length, w = q.w / length;
  return {{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y), 0},
          {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x), 0},
          {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y), 0},
          {0, 0, 0, 1}};
}

std::vector<GltfNode> shown_nodes(const Gltf& gltf) {
  const GltfValue nodes = gltf["nodes"];
  Children children;
  std::vector<glm::dmat4> transforms;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const GltfValue node = nodes.object_at(i);
    children.push_back(node["children"].indices_into("nodes"));
    transforms.push_back(transform_of(node));
  }
  std::vector<GltfNode> shown, open;
  const auto open_all = [&](const std::vector<std::size_t>& list, const glm::dmat4& parent) {
    for (std::size_t i = list.size(); i-- > 0;) {
      open.push_back({list[i], parent * transforms[list[i]]});
    }
  };
  open_all(roots_of(gltf, children), glm::dmat4(1.0));
  while (!open.empty()) {
    shown.push_back(open.back());
    open.pop_back();
    open_all(children[shown.back().index], shown.back().world_from_node);
  }
  return shown;
}

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/assimp_mesh.hpp"

#include <assimp/scene.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/vec3.hpp>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "experiments/errors.hpp"
#include "experiments/scenes/text_file.hpp"

namespace clipscope::experiments {
namespace {

// A mesh of the scene and where it stands.
struct Instance {
  const aiMesh* mesh;
  aiMatrix4x4 world_from_mesh;
};

std::vector<Instance> instances_of(const aiScene& scene) {
  std::vector<Instance> instances;
  std::vector<std::pair<const aiNode*, aiMatrix4x4>> open = {{scene.mRootNode, aiMatrix4x4()}};
  while (!open.empty()) {
    const auto [node, parent] = open.back();
    open.pop_back();
    const aiMatrix4x4 world = parent * node->mTransformation;
    for (unsigned i = 0; i < node->mNumMeshes; ++i) {
      instances.push_back({scene.mMeshes[node->mMeshes[i]], world});
    }
    for (unsigned i = node->mNumChildren; i-- > 0;) {
      open.emplace_back(node->mChildren[i], world);
    }
  }
  return instances;
}

void require_finite(const std::string& name, const aiMesh& mesh, unsigned vertex, const char* what,
                    double value) {
  const std::string defect = defect_of(value);
  if (!defect.empty()) {
    throw InputError(fmt::format("{}: mesh '{}', vertex {}: {} is {}; a finite number was expected",
                                 name, mesh.mName.C_Str(), vertex, what, defect));
  }
}

// The three coordinates of a point in a box, each scaled to [0, 1], the longest side's first.
class BoxCoordinates {
 public:
  explicit BoxCoordinates(const Box& box) : lo_(box.lo), size_(box.size()) {
    std::ranges::stable_sort(axes_, [this](int a, int b) { return size_[a] > size_[b]; });
  }

  double operator()(const std::array<float, 3>& p, int rank) const {
    const int axis = axes_[rank];
    return size_[axis] > 0 ? (p[axis] - lo_[axis]) / size_[axis] : 0.5;
  }

 private:
  glm::dvec3 lo_, size_;
  std::array<int, 3> axes_ = {0, 1, 2};
};

class Flattener {
 public:
  Flattener(const std::string& name, bool has_vertex_normals)
      : name_(name), has_vertex_normals_(has_vertex_normals) {}

  void add(const Instance& instance) {
    Part part{instance.mesh, mesh_.positions.size(), mesh_.triangles.size()};
    add_triangles(*instance.mesh);
    if (mesh_.triangles.size() == part.first_triangle) {
      return;
    }
    add_positions(instance);
    parts_.push_back(part);
  }

  Mesh finish() {
    if (!mesh_.positions.empty()) {
      const BoxCoordinates coordinates(bounding_box(mesh_));
      mesh_.attributes.reserve(mesh_.positions.size());
      for (const Part& part : parts_) {
        add_attributes(part, coordinates);
      }
    }
    return std::move(mesh_);
  }

  void reserve(std::size_t vertices, std::size_t triangles) {
    mesh_.positions.reserve(vertices);
    mesh_.triangles.reserve(triangles);
  }

 private:
  struct Part {
    const aiMesh* mesh;
    std::size_t first_vertex, first_triangle;
  };

  void add_triangles(const aiMesh& mesh) {
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    for (const aiFace& face : std::span(mesh.mFaces, mesh.mNumFaces)) {
      if (face.mNumIndices == 3) {
        const unsigned* corner = face.mIndices;
        mesh_.triangles.push_back({first + corner[0], first + corner[1], first + corner[2]});
      }
    }
  }

  void add_positions(const Instance& instance) {
    const aiMesh& mesh = *instance.mesh;
    const bool moved = !instance.world_from_mesh.IsIdentity();
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D p = moved ? instance.world_from_mesh * mesh.mVertices[i] : mesh.mVertices[i];
      require_finite(name_, mesh, i, "x", p.x);
      require_finite(name_, mesh, i, "y", p.y);
      require_finite(name_, mesh, i, "z", p.z);
      mesh_.positions.push_back({p.x, p.y, p.z});
    }
  }

  void add_attributes(const Part& part, const BoxCoordinates& coordinates) {
    const aiMesh& mesh = *part.mesh;
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const std::array<float, 3>& p = mesh_.positions[part.first_vertex + i];
      auto& [u, v, a, b] = mesh_.attributes.emplace_back();
      u = static_cast<float>(coordinates(p, 0));
      v = static_cast<float>(coordinates(p, 1));
      a = static_cast<float>(2 * coordinates(p, 0) - 1);
      b = static_cast<float>(2 * coordinates(p, 2) - 1);
      if (mesh.HasTextureCoords(0)) {
        u = mesh.mTextureCoords[0][i].x;
        v = mesh.mTextureCoords[0][i].y;
        require_finite(name_, mesh, i, "texture coordinate u", u);
        require_finite(name_, mesh, i, "texture coordinate v", v);
      }
      if (has_vertex_normals_ && mesh.HasNormals()) {
        std::tie(a, b) = unit_normal_xy(mesh, i);
      }
    }
  }

  std::pair<float, float> unit_normal_xy(const aiMesh& mesh, unsigned i) const {
    const aiVector3D& n = mesh.mNormals[i];
    const double length = std::hypot(double{n.x}, double{n.y}, double{n.z});
    require_finite(name_, mesh, i, "the normal's length", length);
    if (length == 0) {
      return {0.0f, 0.0f};
    }
    return {static_cast<float>(n.x / length), static_cast<float>(n.y / length)};
  }

  const std::string& name_;
  bool has_vertex_normals_;
  Mesh mesh_;
  std::vector<Part> parts_;
};

using VertexBits = std::array<std::uint32_t, 3 + kSceneAttributes>;

VertexBits bits_of(const Mesh& mesh, std::size_t vertex) {
  VertexBits bits;
  auto out = bits.begin();
  for (const float x : mesh.positions[vertex]) {
    *out++ = std::bit_cast<std::uint32_t>(x);
  }
  for (const float x : mesh.attributes[vertex]) {
    *out++ = std::bit_cast<std::uint32_t>(x);
  }
  return bits;
}

std::size_t hash_of(const VertexBits& bits) {
  std::uint64_t hash = 0;
  for (const std::uint32_t word : bits) {
    hash = (hash ^ word) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 32;
  }
  return hash;
}

// An open-addressing hash table from vertex bits to the index of the first vertex that has them.
class VertexTable {
 public:
  VertexTable(const Mesh& mesh, std::size_t vertices)
      : mesh_(mesh), slots_(std::bit_ceil(2 * vertices + 1), kEmpty) {}

  // The index of an equal vertex met before, or `index` itself.
  std::uint32_t find_or_add(const VertexBits& bits, std::uint32_t index) {
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t slot = hash_of(bits) & mask;; slot = (slot + 1) & mask) {
      if (slots_[slot] == kEmpty) {
        slots_[slot] = index;
        return index;
      }
      if (bits_of(mesh_, slots_[slot]) == bits) {
        return slots_[slot];
      }
    }
  }

 private:
  static constexpr std::uint32_t kEmpty = ~std::uint32_t{0};

  const Mesh& mesh_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace

void require_valid_indices(const std::string& name, const aiScene& scene) {
  for (const aiMesh* mesh : std::span(scene.mMeshes, scene.mNumMeshes)) {
    for (unsigned i = 0; i < mesh->mNumFaces; ++i) {
      const aiFace& face = mesh->mFaces[i];
      for (const unsigned corner : std::span(face.mIndices, face.mNumIndices)) {
        if (corner >= mesh->mNumVertices) {
          throw InputError(
              fmt::format("{}: mesh '{}', face {} refers to vertex {}, but there are only {}", name,
                          mesh->mName.C_Str(), i, corner, mesh->mNumVertices));
        }
      }
    }
  }
}

Mesh flatten(const std::string& name, const aiScene& scene, bool has_vertex_normals) {
  const std::vector<Instance> instances = instances_of(scene);
  std::size_t vertices = 0, triangles = 0;
  for (const Instance& instance : instances) {
    vertices += instance.mesh->mNumVertices;
    triangles += instance.mesh->mNumFaces;
  }
  if (vertices >= UINT32_MAX) {
    throw InputError(
        fmt::format("{}: {} vertices are too many; fewer than 2^32 expected", name, vertices));
  }
  Flattener flattener(name, has_vertex_normals);
  flattener.reserve(vertices, triangles);
  for (const Instance& instance : instances) {
    flattener.add(instance);
  }
  return flattener.finish();
}

void merge_equal_vertices(Mesh& mesh) {
  constexpr std::uint32_t kUnused = ~std::uint32_t{0};
  std::vector<std::uint32_t> new_index(mesh.positions.size(), kUnused);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      new_index[corner] = 0;
    }
  }
  // Vertices only ever move down, onto places that have been read already.
  VertexTable table(mesh, mesh.positions.size());
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (new_index[i] == kUnused) {
      continue;
    }
    const VertexBits bits = bits_of(mesh, i);
    mesh.positions[kept] = mesh.positions[i];
    mesh.attributes[kept] = mesh.attributes[i];
    new_index[i] = table.find_or_add(bits, kept);
    kept += new_index[i] == kept;
  }
  mesh.positions.resize(kept);
  mesh.attributes.resize(kept);
  mesh.positions.shrink_to_fit();
  mesh.attributes.shrink_to_fit();
  for (auto& triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) {
      corner = new_index[corner];
    }
  }
}

}  // namespace clipscope::experiments

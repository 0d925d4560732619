// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/mesh_file.hpp"

#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "experiments/machine/files.hpp"
#include "experiments/scenes/text_file.hpp"

namespace clipscope::experiments {
namespace {

struct Format {
  std::string_view extension;
  const char* name;  // of what geometry_of yields, for assimp
  std::string (*geometry_of)(const std::string& name, std::string content);
};
constexpr Format kFormats[] = {{".obj", "obj", geometry_of_obj},
                               {".ply", "ply", geometry_of_ply},
                               {".stl", "stl", geometry_of_stl},
                               {".gltf", "glb", geometry_of_gltf},
                               {".glb", "glb", geometry_of_gltf}};

// Keeps assimp from opening the files that a mesh file names, such as materials.
class NoFiles : public Assimp::IOSystem {
 public:
  bool Exists(const char*) const override { return false; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char*, const char*) override { return nullptr; }
  void Close(Assimp::IOStream*) override {}
};

void require_valid_indices(const std::string& name, const aiScene& scene) {
  for (const aiMesh* mesh : std::span(scene.mMeshes, scene.mNumMeshes)) {
    for (unsigned i = 0; i < mesh->mNumFaces; ++i) {
      const aiFace& face = mesh->mFaces[i];
      for (const unsigned corner : std::span(face.mIndices, face.mNumIndices)) {
        if (corner < mesh->mNumVertices) continue;
        refuse(name, "mesh '{}', face {} refers to vertex {}, but there are only {}",
               mesh->mName.C_Str(), i, corner, mesh->mNumVertices);
      }
    }
  }
}

bool is_triangle(const aiFace& face) { return face.mNumIndices == 3; }

bool has_triangles(const aiMesh& mesh) {
  return std::ranges::any_of(std::span(mesh.mFaces, mesh.mNumFaces), is_triangle);
}

// A mesh of the scene that has triangles, and where it stands.
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
    for (const unsigned mesh : std::span(node->mMeshes, node->mNumMeshes)) {
      if (has_triangles(*scene.mMeshes[mesh])) instances.push_back({scene.mMeshes[mesh], world});
    }
    for (unsigned i = node->mNumChildren; i-- > 0;) open.emplace_back(node->mChildren[i], world);
  }
  return instances;
}

// The coordinates of points in a box, each scaled to [0, 1], the longest side's first.
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

// Makes one mesh of the instances.
class Flattener {
 public:
  Flattener(const std::string& name, const aiScene& scene, bool has_vertex_normals)
      : name_(name), has_vertex_normals_(has_vertex_normals), instances_(instances_of(scene)) {}

  Mesh flatten() {
    std::size_t vertices = 0, triangles = 0;
    for (const Instance& instance : instances_) {
      vertices += instance.mesh->mNumVertices;
      triangles += instance.mesh->mNumFaces;
    }
    if (vertices >= UINT32_MAX) {
      refuse(name_, "{} vertices are too many; fewer than 2^32 expected", vertices);
    }
    mesh_.positions.reserve(vertices);
    mesh_.triangles.reserve(triangles);
    for (const Instance& instance : instances_) add_positions(instance);
    if (mesh_.positions.empty()) return {};
    mesh_.attributes.reserve(mesh_.positions.size());
    const BoxCoordinates coordinates(bounding_box(mesh_));
    for (const Instance& instance : instances_) add_attributes(*instance.mesh, coordinates);
    return std::move(mesh_);
  }

 private:
  // Adds triangles and their vertices' positions.
  void add_positions(const Instance& instance) {
    const auto& [mesh, world_from_mesh] = instance;
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    for (const aiFace& face : std::span(mesh->mFaces, mesh->mNumFaces)) {
      const unsigned* corner = face.mIndices;
      if (!is_triangle(face)) continue;
      mesh_.triangles.push_back({first + corner[0], first + corner[1], first + corner[2]});
    }
    const bool moved = !world_from_mesh.IsIdentity();
    for (unsigned i = 0; i < mesh->mNumVertices; ++i) {
      const aiVector3D p = moved ? world_from_mesh * mesh->mVertices[i] : mesh->mVertices[i];
      for (const auto& [axis, value] : {std::pair{"x", p.x}, {"y", p.y}, {"z", p.z}}) {
        require_finite_at(*mesh, i, axis, value);
      }
      mesh_.positions.push_back({p.x, p.y, p.z});
    }
  }

  // Adds those of the mesh that comes next by position.
  void add_attributes(const aiMesh& mesh, const BoxCoordinates& coordinates) {
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const std::array<float, 3>& p = mesh_.positions[mesh_.attributes.size()];
      auto& [u, v, a, b] = mesh_.attributes.emplace_back();
      u = static_cast<float>(coordinates(p, 0));
      v = static_cast<float>(coordinates(p, 1));
      a = static_cast<float>(2 * coordinates(p, 0) - 1);
      b = static_cast<float>(2 * coordinates(p, 2) - 1);
      if (mesh.HasTextureCoords(0)) {
        u = mesh.mTextureCoords[0][i].x;
        v = mesh.mTextureCoords[0][i].y;
        require_finite_at(mesh, i, "texture coordinate u", u);
        require_finite_at(mesh, i, "texture coordinate v", v);
      }
      if (has_vertex_normals_ && mesh.HasNormals()) {
        const aiVector3D& n = mesh.mNormals[i];
        const double length = std::hypot(double{n.x}, double{n.y}, double{n.z});
        require_finite_at(mesh, i, "the normal's length", length);
        a = length == 0 ? 0.0f : static_cast<float>(n.x / length);
        b = length == 0 ? 0.0f : static_cast<float>(n.y / length);
      }
    }
  }

  void require_finite_at(const aiMesh& mesh, unsigned vertex, const char* what,
                         double value) const {
    require_finite(value, [&] {
      return fmt::format("{}: mesh '{}', vertex {}: {}", name_, mesh.mName.C_Str(), vertex, what);
    });
  }

  const std::string& name_;
  bool has_vertex_normals_;
  std::vector<Instance> instances_;
  Mesh mesh_;
};

using VertexBits = std::array<std::uint32_t, 3 + kSceneAttributes>;

VertexBits bits_of(const Mesh& mesh, std::size_t vertex) {
  VertexBits bits;
  const auto as_bits = [](float x) { return std::bit_cast<std::uint32_t>(x); };
  const auto rest = std::ranges::transform(mesh.positions[vertex], bits.begin(), as_bits).out;
  std::ranges::transform(mesh.attributes[vertex], rest, as_bits);
  return bits;
}

struct HashBits {
  std::size_t operator()(const VertexBits& bits) const {
    return std::hash<std::string_view>{}({reinterpret_cast<const char*>(&bits), sizeof bits});
  }
};

// Leaves one vertex of those with the same bits, and none that no triangle has.
void merge_equal_vertices(Mesh& mesh) {
  std::vector<bool> is_used(mesh.positions.size());
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) is_used[corner] = true;
  }
  std::unordered_map<VertexBits, std::uint32_t, HashBits> kept;
  std::vector<std::uint32_t> new_index(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (!is_used[i]) continue;
    const auto next = static_cast<std::uint32_t>(kept.size());
    new_index[i] = kept.try_emplace(bits_of(mesh, i), next).first->second;
    // Vertices only ever move down, onto places that have been read already.
    mesh.positions[new_index[i]] = mesh.positions[i];
    mesh.attributes[new_index[i]] = mesh.attributes[i];
  }
  mesh.positions.resize(kept.size());
  mesh.attributes.resize(kept.size());
  mesh.positions.shrink_to_fit();
  mesh.attributes.shrink_to_fit();
  for (auto& triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) corner = new_index[corner];
  }
}

Mesh read_with_assimp(const std::string& name, const Format& format, std::string bytes) {
  Assimp::Importer importer;
  importer.SetIOHandler(new NoFiles);  // which the importer deletes
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, format.name);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    refuse(name, "assimp can't read it: {}", importer.GetErrorString());
  }
  bytes = {};
  require_valid_indices(name, *scene);
  scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
  if (scene == nullptr) refuse(name, "assimp can't triangulate it: {}", importer.GetErrorString());
  return Flattener(name, *scene, format.extension != ".stl").flatten();
}

}  // namespace

Mesh load_mesh(const std::filesystem::path& path) {
  const std::string name = path.string(), extension = extension_of(path);
  require_file(path);
  const auto format = std::ranges::find(kFormats, extension, &Format::extension);
  if (format == std::end(kFormats)) {
    refuse(name, "the extension '{}' is no mesh format; .obj, .ply, .stl, .gltf or .glb expected",
           extension);
  }
  Mesh mesh = read_with_assimp(name, *format, format->geometry_of(name, read_bytes(path)));
  if (mesh.triangles.empty()) refuse(name, "the file has no triangles");
  merge_equal_vertices(mesh);
  return mesh;
}

}  // namespace clipscope::experiments

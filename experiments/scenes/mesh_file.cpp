// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks a mesh file, has assimp read it, and turns assimp's scene into a Mesh.
#include "experiments/scenes/mesh_file.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/core.h>

#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <cctype>
#include <string>
#include <string_view>
#include <utility>

#include "experiments/errors.hpp"
#include "experiments/scenes/assimp_mesh.hpp"
#include "experiments/scenes/file_bytes.hpp"
#include "experiments/scenes/gltf.hpp"
#include "experiments/scenes/mesh_checks.hpp"

namespace clipscope::experiments {
namespace {

// What assimp gets to read: checked bytes, and the extension that tells it the format.
struct SoundFile {
  std::string format;
  std::string bytes;
};

std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return extension;
}

SoundFile read_and_check(const std::filesystem::path& path) {
  const std::string name = path.string(), extension = extension_of(path);
  require_file(path);
  if (extension == ".obj") {
    return {"obj", geometry_of_obj(name, read_bytes(path))};
  }
  if (extension == ".ply") {
    std::string bytes = read_bytes(path);
    check_ply(name, bytes);
    return {"ply", std::move(bytes)};
  }
  if (extension == ".stl") {
    return {"stl", geometry_of_stl(name, read_bytes(path))};
  }
  if (extension == ".gltf" || extension == ".glb") {
    return {"glb", geometry_of(read_gltf(path, read_bytes(path)))};
  }
  throw InputError(fmt::format(
      "{}: the extension '{}' is no mesh format; .obj, .ply, .stl, .gltf or .glb expected", name,
      extension));
}

// Keeps assimp from opening the files that a mesh file names, such as materials.
class NoFiles : public Assimp::IOSystem {
 public:
  bool Exists(const char*) const override { return false; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char*, const char*) override { return nullptr; }
  void Close(Assimp::IOStream*) override {}
};

}  // namespace

Mesh load_mesh(const std::filesystem::path& path) {
  SoundFile file = read_and_check(path);
  const std::string name = path.string();
  Mesh mesh;
  {
    Assimp::Importer importer;
    importer.SetIOHandler(new NoFiles);  // which the importer deletes
    const aiScene* scene =
        importer.ReadFileFromMemory(file.bytes.data(), file.bytes.size(), 0, file.format.c_str());
    if (scene == nullptr || scene->mRootNode == nullptr) {
      throw InputError(
          fmt::format("{}: assimp can't read it: {}", name, importer.GetErrorString()));
    }
    file.bytes = {};
    require_valid_indices(name, *scene);
    scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
    if (scene == nullptr) {
      throw InputError(
          fmt::format("{}: assimp can't triangulate it: {}", name, importer.GetErrorString()));
    }
    mesh = flatten(name, *scene, file.format != "stl");
  }
  if (mesh.triangles.empty()) {
    throw InputError(fmt::format("{}: the file has no triangles", name));
  }
  merge_equal_vertices(mesh);
  return mesh;
}

}  // namespace clipscope::experiments

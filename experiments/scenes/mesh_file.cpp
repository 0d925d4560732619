// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/mesh_file.hpp"

#include <algorithm>
#include <iterator>

#include "experiments/machine/files.hpp"
#include "experiments/scenes/text_file.hpp"

namespace clipscope::experiments {
namespace {

struct MeshFormat {
  std::string_view extension;
  Mesh (*read)(const std::string& name, std::string_view content);
};
constexpr MeshFormat kMeshFormats[] = {{".obj", read_obj},
                                       {".ply", read_ply},
                                       {".stl", read_stl},
                                       {".gltf", read_gltf_mesh},
                                       {".glb", read_gltf_mesh}};

}  // namespace

Mesh load_mesh(const std::filesystem::path& path) {
  const std::string name = path.string(), extension = extension_of(path);
  require_file(path);
  const auto format = std::ranges::find(kMeshFormats, extension, &MeshFormat::extension);
  if (format == std::end(kMeshFormats)) {
    refuse(name, "the extension '{}' is no mesh format; .obj, .ply, .stl, .gltf or .glb expected",
           extension);
  }
  return format->read(name, read_bytes(path));
}

}  // namespace clipscope::experiments

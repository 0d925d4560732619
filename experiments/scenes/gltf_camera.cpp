// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/gltf_camera.hpp"

#include <fmt/ranges.h>

#include <cmath>
#include <numbers>

#include "experiments/machine/files.hpp"
#include "experiments/scenes/gltf_nodes.hpp"

namespace clipscope::experiments {
namespace {

// A number of the camera that must be positive.
double positive(const GltfValue& value) {
  const double number = value.real();
  if (!(number > 0)) value.fail("is {}; a number > 0 expected", number);
  return number;
}

void read_depths(const GltfValue& numbers, GltfCamera& camera) {
  if (numbers["zfar"]) camera.far = positive(numbers["zfar"]);
  if (camera.far && !(camera.near < *camera.far)) {
    numbers["zfar"].fail("is {}; more than znear, which is {}, expected", *camera.far, camera.near);
  }
}

void read_perspective(const GltfValue& numbers, GltfCamera& camera) {
  camera.fovy = positive(numbers["yfov"]);
  if (!(camera.fovy < std::numbers::pi)) {
    numbers["yfov"].fail("is {}; radians below pi expected", camera.fovy);
  }
  if (numbers["aspectRatio"]) camera.aspect = positive(numbers["aspectRatio"]);
  camera.near = positive(numbers["znear"]);
  read_depths(numbers, camera);
}

void read_orthographic(const GltfValue& numbers, GltfCamera& camera) {
  camera.kind = ProjectionKind::parallel;
  camera.xmag = positive(numbers["xmag"]);
  camera.ymag = positive(numbers["ymag"]);
  camera.near = numbers["znear"].real();
  if (!numbers["zfar"]) numbers["zfar"].fail("is missing");
  read_depths(numbers, camera);
}

GltfCamera camera_of(const GltfValue& camera, const GltfValue& node) {
  GltfCamera read;
  read.name = node.place();
  for (const GltfValue& name : {camera["name"], node["name"]}) {
    if (name && name->is_string()) read.name = name->get<std::string>();
  }
  const GltfValue type = camera["type"];
  if (type && *type == "perspective") {
    read_perspective(camera["perspective"], read);
  } else if (type && *type == "orthographic") {
    read_orthographic(camera["orthographic"], read);
  } else {
    type.fail("is {}; \"perspective\" or \"orthographic\" expected",
              type ? type->dump() : "missing");
  }
  return read;
}

}  // namespace

std::vector<GltfCamera> read_gltf_cameras(const std::filesystem::path& path) {
  const std::string extension = extension_of(path), name = path.string();
  require_file(path);
  if (extension != ".gltf" && extension != ".glb") {
    refuse(name, "the extension '{}' is no glTF file; .gltf or .glb expected", extension);
  }
  return read_gltf_cameras(name, read_bytes(path));
}

std::vector<GltfCamera> read_gltf_cameras(const std::string& name, std::string_view content) {
  const Gltf gltf = read_gltf(name, content);
  std::vector<GltfCamera> cameras;
  for (const auto& [index, world_from_node] : shown_nodes(gltf)) {
    const GltfValue node = gltf["nodes"].object_at(index), camera = node["camera"];
    if (!camera) continue;
    cameras.push_back(camera_of(gltf["cameras"].object_at(camera.index_into("cameras")), node));
    cameras.back().world_from_camera = world_from_node;
  }
  return cameras;
}

const GltfCamera& find_camera(const std::vector<GltfCamera>& cameras, const std::string& wanted,
                              const std::filesystem::path& path) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    if (wanted == std::to_string(i) || wanted == cameras[i].name) return cameras[i];
    names.push_back(fmt::format("{} ({})", i, cameras[i].name));
  }
  throw UsageError(fmt::format("--camera: {} has no camera '{}'; it has: {}", path.string(), wanted,
                               names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
}

std::array<double, 16> pose_of(const GltfCamera& camera) {
  std::array<double, 16> numbers;
  for (int i = 0; i < 16; ++i) {
    numbers[static_cast<std::size_t>(i)] = camera.world_from_camera[i % 4][i / 4];
  }
  return numbers;
}

Frustum<double> frustum_of(const GltfCamera& camera, const CameraOptions& options) {
  const double picture = options.aspect;
  const bool is_given = picture != CameraOptions().aspect;
  Frustum<double> f;
  f.kind = camera.kind;
  f.near = options.near.value_or(camera.near);
  const std::optional<double> far = options.far ? options.far : camera.far;
  f.infinite_far = !far || std::isinf(*far);
  f.far = f.infinite_far ? 0 : *far;
  f.top = camera.ymag;
  f.right = is_given ? camera.ymag * picture : camera.xmag;
  if (camera.kind == ProjectionKind::perspective) {
    f.top = f.near * std::tan(camera.fovy / 2);
    f.right = f.top * (is_given ? picture : camera.aspect.value_or(picture));
  }
  f.left = -f.right;
  f.bottom = -f.top;
  return f;
}

}  // namespace clipscope::experiments

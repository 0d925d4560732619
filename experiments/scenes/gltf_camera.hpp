// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cameras of a glTF file, each where its node puts it.
//
// Source: Khronos Group, "glTF 2.0 Specification", 2021, section 3.10. A camera looks along its
// node's -z axis, +y up; numbers are as the file has them, in double, and nothing is rounded.
#pragma once

#include <array>
#include <filesystem>
#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/scenes/camera.hpp"
#include "spaces/projection.hpp"

namespace clipscope::experiments {

struct GltfCamera {
  std::string name;  // the node's, or else the camera's, or else "nodes[0]"
  ProjectionKind kind = ProjectionKind::perspective;
  double fovy = 0;               // perspective: the whole vertical angle, in radians
  std::optional<double> aspect;  // perspective: width over height; none: that of the picture
  double xmag = 0, ymag = 0;     // parallel: half the width and half the height, in world units
  double near = 0;
  std::optional<double> far;  // none (perspective only): infinite
  // As the nodes have it, scale included; a camera in a scaled node has no rigid pose.
  glm::dmat4 world_from_camera = glm::dmat4(1.0);
};

// The cameras of all shown nodes, in the order of shown_nodes; the file needs no mesh. Cameras that
// no shown node refers to stand nowhere and are left out.
// Errors: InputError for what is no .gltf or .glb file, and for a camera whose numbers are missing
// or enclose no volume, naming its place.
std::vector<GltfCamera> read_gltf_cameras(const std::filesystem::path& path);
// The same of what a file of that name holds.
std::vector<GltfCamera> read_gltf_cameras(const std::string& name, std::string_view content);

// The camera of a file that has this name or number. Errors: UsageError that names all there are.
const GltfCamera& find_camera(const std::vector<GltfCamera>& cameras, const std::string& wanted,
                              const std::filesystem::path& path);

// The camera as options of make_views: its pose, by rows; and what it sees. The picture's aspect is
// that of the options where they have another than their default or the camera has none, and so are
// near and far where they are given.
std::array<double, 16> pose_of(const GltfCamera& camera);
Frustum<double> frustum_of(const GltfCamera& camera, const CameraOptions& options);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Moves triangles into view space, and finds a scene by its name or file.
#include "experiments/scenes/scene.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <filesystem>

#include "experiments/errors.hpp"
#include "experiments/scenes/builtin.hpp"
#include "experiments/scenes/camera.hpp"
#include "experiments/scenes/mesh_file.hpp"

namespace clipscope::experiments {
namespace {

// One row of an affine transform, a x + b y + c z + d in double.
struct AffineRow {
  double a, b, c, d;

  double operator()(const std::array<float, 3>& p) const {
    return a * double{p[0]} + b * double{p[1]} + c * double{p[2]} + d;
  }
};

AffineRow row_of(const glm::dmat4& m, int row) {
  return {m[0][row], m[1][row], m[2][row], m[3][row]};
}

// Fills each corner of each triangle, its position by `place`.
template <class Place>
void gather(const Mesh& mesh, std::size_t first, std::span<SceneTriangle> out, Place&& place) {
  for (std::size_t i = 0; i < out.size(); ++i) {
    const std::array<std::uint32_t, 3>& corners = mesh.triangles[first + i];
    for (int k = 0; k < 3; ++k) {
      out[i][k].position = place(mesh.positions[corners[k]]);
      out[i][k].attributes.values = mesh.attributes[corners[k]];
    }
  }
}

bool looks_like_a_file(std::string_view name) {
  if (name.find_first_of("./") != std::string_view::npos) {
    return true;
  }
  std::error_code ignored;
  return std::filesystem::exists(std::filesystem::path(name), ignored);
}

void place_camera(Scene& scene, const CameraOptions& camera) {
  if (is_camera_set(camera)) {
    if (is_in_view_space(scene)) {
      throw UsageError(fmt::format(
          "the scene '{}' is given in view space and has no camera to move: leave --eye, --target, "
          "--up, --fovy, --aspect, --near, --far and --walk away",
          scene.name));
    }
    scene.views = make_views(scene.mesh, camera);
  }
  for (View& view : scene.views) {
    view.frustum.depth = camera.depth;
  }
}

}  // namespace

void view_triangles(const Scene& scene, const View& view, std::size_t first,
                    std::span<SceneTriangle> out) {
  assert(first + out.size() <= scene.mesh.triangles.size());
  const glm::dmat4& m = view.view_from_world;
  if (m == glm::dmat4(1.0)) {
    gather(scene.mesh, first, out, [](const auto& p) { return Vec3<float>(p[0], p[1], p[2]); });
    return;
  }
  const AffineRow x = row_of(m, 0), y = row_of(m, 1), z = row_of(m, 2);
  gather(scene.mesh, first, out, [=](const auto& p) {
    return Vec3<float>(static_cast<float>(x(p)), static_cast<float>(y(p)),
                       static_cast<float>(z(p)));
  });
}

bool is_in_view_space(const Scene& scene) {
  return std::ranges::all_of(
      scene.views, [](const View& view) { return view.view_from_world == glm::dmat4(1.0); });
}

Box bounding_box(const Mesh& mesh) {
  assert(!mesh.positions.empty());
  std::array<float, 3> lo = mesh.positions.front(), hi = lo;
  for (const std::array<float, 3>& p : mesh.positions) {
    for (int axis = 0; axis < 3; ++axis) {
      lo[axis] = std::min(lo[axis], p[axis]);
      hi[axis] = std::max(hi[axis], p[axis]);
    }
  }
  return {{lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}};
}

Scene load_scene(std::string_view name_or_file, const SceneOptions& options,
                 const CameraOptions& camera) {
  if (is_builtin_scene(name_or_file) || !looks_like_a_file(name_or_file)) {
    Scene scene = make_builtin_scene(name_or_file, options);
    place_camera(scene, camera);
    return scene;
  }
  const std::filesystem::path path(name_or_file);
  Scene scene;
  scene.name = path.filename().string();
  scene.mesh = load_mesh(path);
  scene.description = fmt::format("{} triangles of {}", scene.mesh.triangles.size(), path.string());
  scene.views = make_views(scene.mesh, camera);
  return scene;
}

}  // namespace clipscope::experiments

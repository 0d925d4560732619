// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <span>

#include "experiments/machine/errors.hpp"
#include "experiments/scenes/builtin.hpp"
#include "experiments/scenes/camera.hpp"
#include "experiments/scenes/gltf_camera.hpp"
#include "experiments/scenes/mesh_file.hpp"

namespace clipscope::experiments {
namespace {

using glm::dvec3;

bool looks_like_a_file(std::string_view name) {
  if (name.find_first_of("./") != std::string_view::npos) return true;
  std::error_code ignored;
  return std::filesystem::exists(std::filesystem::path(name), ignored);
}

void place_camera(Scene& scene, const CameraOptions& camera) {
  CameraOptions unset;
  unset.depth = camera.depth;
  if (camera != unset) {
    const auto has_moved = [](const View& view) { return view.view_from_world != glm::dmat4(1.0); };
    // A matrix alone takes the place of the frustum; nothing moves.
    const bool stays = camera.matrix && !camera.eye && !camera.pose;
    if (!stays && std::ranges::none_of(scene.views, has_moved)) {
      throw UsageError(fmt::format(
          "the scene '{}' is given in view space and has no camera to move: leave the options of the camera away; a --matrix alone is taken",
          scene.name));
    }
    scene.views = make_views(scene.mesh, camera);
  }
  for (View& view : scene.views) view.frustum.depth = camera.depth;
}

// Options that say of a camera of the file what the file says.
CameraOptions with_gltf_camera(const CameraOptions& options, const std::filesystem::path& path) {
  const std::vector<GltfCamera> cameras = read_gltf_cameras(path);
  const GltfCamera& camera = find_camera(cameras, *options.gltf_camera, path);
  CameraOptions unset;
  unset.depth = options.depth;
  unset.gltf_camera = options.gltf_camera;
  unset.near = options.near;
  unset.far = options.far;
  unset.aspect = options.aspect;
  if (options != unset) {
    throw UsageError(
        "--camera: the file says where the camera is and what it sees; only --near, --far, --aspect and --depth may change that");
  }
  CameraOptions placed;
  placed.depth = options.depth;
  placed.pose = pose_of(camera);
  placed.frustum = frustum_of(camera, options);
  return placed;
}

// Moves vertices of the mesh, each at point(mesh, vertex), to view space, each rounded to T once.
template <class T, class Point>
void fill(const Scene& scene, const View& view, std::size_t first,
          std::span<ViewTriangle<T, kSceneAttributes>> out, const Point& point) {
  assert(first + out.size() <= scene.mesh.triangles.size());
  const Mesh& mesh = scene.mesh;
  const glm::dmat4& m = view.view_from_world;
  const bool is_identity = m == glm::dmat4(1.0);
  const dvec3 x_axis(m[0]), y_axis(m[1]), z_axis(m[2]), origin(m[3]);
  for (std::size_t i = 0; i < out.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t corner = mesh.triangles[first + i][k];
      const dvec3 p = point(mesh, corner);
      const dvec3 moved = x_axis * p.x + y_axis * p.y + z_axis * p.z + origin;
      out[i][k].position = Vec3<T>(is_identity ? p : moved);
      std::ranges::copy(mesh.attributes[corner], out[i][k].attributes.values.begin());
    }
  }
}

}  // namespace

void view_triangles(const Scene& scene, const View& view, std::size_t first,
                    std::span<SceneTriangle> out) {
  fill(scene, view, first, out, point_of);
}

void view_triangles(const Scene& scene, const View& view, std::size_t first,
                    std::span<DoubleSceneTriangle> out) {
  fill(scene, view, first, out, point_in_double);
}

Box bounding_box(const Mesh& mesh) {
  assert(!mesh.positions.empty());
  Box box{point_in_double(mesh, 0), point_in_double(mesh, 0)};
  for (std::size_t i = 1; i < mesh.positions.size(); ++i) {
    box.lo = glm::min(box.lo, point_in_double(mesh, i));
    box.hi = glm::max(box.hi, point_in_double(mesh, i));
  }
  return box;
}

Scene load_scene(std::string_view name_or_file, const SceneOptions& options,
                 const CameraOptions& camera) {
  const bool is_builtin = std::ranges::count(builtin_scenes(), name_or_file, &SceneInfo::name) > 0;
  if (is_builtin || !looks_like_a_file(name_or_file)) {
    if (camera.gltf_camera) {
      throw UsageError(fmt::format(
          "--camera: '{}' is a built-in scene; the option takes a camera of a glTF file",
          name_or_file));
    }
    Scene scene = make_builtin_scene(name_or_file, options);
    place_camera(scene, camera);
    return scene;
  }
  const std::filesystem::path path(name_or_file);
  Scene scene;
  scene.name = path.filename().string();
  scene.mesh = load_mesh(path);
  scene.description = fmt::format("{} triangles of {}", scene.mesh.triangles.size(), path.string());
  if (!camera.gltf_camera) {
    scene.views = make_views(scene.mesh, camera);
    return scene;
  }
  scene.views = make_views(scene.mesh, with_gltf_camera(camera, path));
  scene.views.front().label = "camera " + *camera.gltf_camera;
  return scene;
}

Spacing spacing_of(const Scene& scene, std::size_t limit) {
  const std::size_t triangles = scene.mesh.triangles.size();
  if (limit == 0 || triangles <= limit) return {triangles, 1};
  const std::size_t stride = (triangles + limit - 1) / limit;
  return {(triangles + stride - 1) / stride, stride};
}

std::vector<SampledView> sampled_views(const Scene& scene, std::size_t limit) {
  std::vector<SampledView> sampled;
  const Spacing spacing = spacing_of(scene, std::max<std::size_t>(1, limit / scene.views.size()));
  Random random(1);
  for (const View& view : scene.views) {
    auto& [_, triangles, numbers] = sampled.emplace_back(SampledView{view, {}});
    for (std::size_t i = 0; i < spacing.count; ++i) numbers.push_back(i * spacing.stride);
    random.shuffle(std::span(numbers));
    for (const std::size_t number : numbers) {
      view_triangles(scene, view, number, {&triangles.emplace_back(), 1});
    }
  }
  return sampled;
}

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of built-in scenes, and what their makers share.
#include "experiments/scenes/builtin.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "experiments/errors.hpp"
#include "experiments/scenes/camera.hpp"
#include "experiments/scenes/families.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::array kScenes = {
    SceneInfo{"teapot", "the Utah teapot from outside, close by and with the near plane inside it"},
    SceneInfo{"floor",
              "a checkerboard under a grazing camera, quads far behind and in front of the eye"},
    SceneInfo{"corridor",
              "a corridor from inside, every triangle reaching from behind the eye past far"},
    SceneInfo{"terrain", "a fractal height field, flown over, close to the ground and under it"},
    SceneInfo{"soup", "random triangles as in a game: 60 % inside, 35 % outside, 5 % straddling"},
    SceneInfo{"soup_inside", "random triangles, all inside the volume"},
    SceneInfo{"soup_outside", "random triangles, each outside one plane with all its vertices"},
    SceneInfo{"soup_straddling",
              "random triangles across the volume's border, in front of the eye"},
    SceneInfo{"soup_behind",
              "random triangles from inside the volume to behind the eye, across w = 0"},
    SceneInfo{"slivers", "needles, near-collinear and near-planar triangles, edges of 1e-4 to 1e6"},
};

using Maker = Scene (*)(const SceneOptions&);

// In the order of kScenes.
constexpr std::array<Maker, kScenes.size()> kMakers = {
    make_teapot_scene,       make_floor_scene,           make_corridor_scene,
    make_terrain_scene,      make_game_soup_scene,       make_inside_soup_scene,
    make_outside_soup_scene, make_straddling_soup_scene, make_behind_soup_scene,
    make_slivers_scene,
};

auto find_scene(std::string_view name) {
  return std::ranges::find(kScenes, name, &SceneInfo::name);
}

}  // namespace

std::span<const SceneInfo> builtin_scenes() { return kScenes; }

bool is_builtin_scene(std::string_view name) { return find_scene(name) != kScenes.end(); }

Scene make_builtin_scene(std::string_view name, const SceneOptions& options) {
  const auto info = find_scene(name);
  if (info == kScenes.end()) {
    std::vector<std::string_view> names;
    std::ranges::transform(kScenes, std::back_inserter(names), &SceneInfo::name);
    throw UsageError(
        fmt::format("unknown scene '{}'; there are {}, or give a mesh file (.obj, .ply, "
                    ".stl, .gltf, .glb)",
                    name, fmt::join(names, ", ")));
  }
  Scene scene = kMakers[static_cast<std::size_t>(info - kScenes.begin())](options);
  scene.name = info->name;
  scene.description = info->description;
  return scene;
}

std::uint32_t add_vertex(Mesh& mesh, const glm::dvec3& position,
                         const std::array<double, kSceneAttributes>& attributes) {
  const auto index = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.push_back({static_cast<float>(position.x), static_cast<float>(position.y),
                            static_cast<float>(position.z)});
  std::array<float, kSceneAttributes>& rounded = mesh.attributes.emplace_back();
  std::ranges::transform(attributes, rounded.begin(),
                         [](double a) { return static_cast<float>(a); });
  return index;
}

void add_sheet(Mesh& mesh, const Sheet& sheet) {
  const auto& c = sheet.corners;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int j = 0; j <= sheet.rows; ++j) {
    for (int i = 0; i <= sheet.columns; ++i) {
      const double s = double(i) / sheet.columns, t = double(j) / sheet.rows;
      const glm::dvec3 lower = c[0] * (1 - s) + c[1] * s, upper = c[3] * (1 - s) + c[2] * s;
      add_vertex(mesh, lower * (1 - t) + upper * t,
                 {s * sheet.u_tiles, t * sheet.v_tiles, 2 * s - 1, 2 * t - 1});
    }
  }
  const auto width = static_cast<std::uint32_t>(sheet.columns) + 1;
  for (int j = 0; j < sheet.rows; ++j) {
    for (int i = 0; i < sheet.columns; ++i) {
      const std::uint32_t a =
          first + static_cast<std::uint32_t>(j) * width + static_cast<std::uint32_t>(i);
      mesh.triangles.push_back({a, a + 1, a + width + 1});
      mesh.triangles.push_back({a, a + width + 1, a + width});
    }
  }
}

View make_view(std::string label, const glm::dvec3& eye, const glm::dvec3& target, double near,
               double far) {
  return {std::move(label), look_at(eye, target, {0, 1, 0}),
          perspective_frustum(60, 16.0 / 9.0, near, far)};
}

View identity_view() {
  return {"as made", glm::dmat4(1.0), perspective_frustum(60, 16.0 / 9.0, 0.1, 1000)};
}

}  // namespace clipscope::experiments

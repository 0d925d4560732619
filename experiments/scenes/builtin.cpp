// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/builtin.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "experiments/machine/errors.hpp"
#include "experiments/scenes/camera.hpp"

namespace clipscope::experiments {
namespace {

Scene floor_scene(const SceneOptions& options) {
  constexpr double kSide = 2000;
  Scene scene;
  // One tile per unit of length.
  add_sheet(scene.mesh, ground(kSide, options.quick ? 4 : 10, kSide));
  scene.views = {
      make_view("standing", {3, 1.7, 5}, {40, 0, -90}, 0.1, 5000),
      make_view("short far plane", {3, 1.7, 5}, {-60, 0, -70}, 0.1, 300),
      make_view("lying", {-31, 0.05, 7}, {-20, 0.04, -100}, 0.1, 5000),
      make_view("skimming", {120, 0.001, 30}, {119, 0.0009, 20}, 0.01, 5000),
      make_view("steep", {-70, 12, -80}, {-68, 0, -83}, 0.5, 5000),
      make_view("from above", {10, 600, 10}, {400, 0, -300}, 1, 5000),
  };
  return scene;
}

Scene corridor_scene(const SceneOptions& options) {
  constexpr double kWidth = 1.2, kHeight = 2.5, kHalfLength = 100;
  Scene scene;
  const glm::dvec3 a(-kWidth, 0, kHalfLength), b(kWidth, 0, kHalfLength);
  const glm::dvec3 c(kWidth, kHeight, kHalfLength), d(-kWidth, kHeight, kHalfLength);
  const glm::dvec3 away(0, 0, -2 * kHalfLength);
  // Each wall is cut along its length only, so that every triangle is as long as the corridor.
  for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, d}, {d, a}}) {
    add_sheet(scene.mesh, {.corners = {{from, to, to + away, from + away}},
                           .columns = options.quick ? 4 : 20,
                           .rows = 1,
                           .u_tiles = 2,
                           .v_tiles = 2 * kHalfLength});
  }
  scene.views = {
      make_view("ahead", {0, 1.7, 10}, {0, 1.6, 0}, 0.1, 60),
      make_view("along a wall", {1.15, 1.4, 0}, {1.1, 1.3, -10}, 0.1, 60),
      make_view("at a wall", {0, 1.2, -20}, {-1.2, 1, -20.7}, 0.1, 60),
      make_view("at the floor", {0.3, 0.2, 30}, {0.1, 0, 29}, 0.05, 60),
      make_view("far ahead", {-0.4, 2.2, 5}, {0.2, 1.5, -95}, 0.01, 80),
  };
  return scene;
}

Scene soup_scene(const SoupShares& shares, const SceneOptions& options) {
  Scene scene;
  scene.views = {identity_view()};
  const Frustum<float>& frustum = scene.views.front().frustum;
  scene.mesh = make_soup(shares, options.quick ? 4000 : 20000, options.seed, frustum);
  return scene;
}

Scene teapot_scene(const SceneOptions& options) {
  Scene scene;
  scene.mesh = teapot_mesh(options.quick ? 5 : 10);
  scene.views = make_views(scene.mesh, {});
  return scene;
}

Scene terrain_scene(const SceneOptions& options) {
  return terrain_of_levels(options.quick ? 6 : 7, options.seed);
}

constexpr SceneInfo kScenes[] = {
    {"teapot", "the Utah teapot from outside, close by and with the near plane inside it",
     teapot_scene},
    {"floor", "a checkerboard under a grazing camera, quads far behind and in front of the eye",
     floor_scene},
    {"corridor", "a corridor from inside, every triangle reaching from behind the eye past far",
     corridor_scene},
    {"terrain", "a fractal height field, flown over, close to the ground and under it",
     terrain_scene},
    {"soup", "random triangles as in a game: 60 % inside, 35 % outside, 5 % straddling",
     [](const SceneOptions& options) {
       return soup_scene({.inside = 60, .outside = 35, .straddling = 5}, options);
     }},
    {"soup_inside", "random triangles, all inside the volume",
     [](const SceneOptions& options) { return soup_scene({.inside = 1}, options); }},
    {"soup_outside", "random triangles, each outside one plane with all its vertices",
     [](const SceneOptions& options) { return soup_scene({.outside = 1}, options); }},
    {"soup_straddling", "random triangles across the volume's border, in front of the eye",
     [](const SceneOptions& options) { return soup_scene({.straddling = 1}, options); }},
    {"soup_behind", "random triangles from inside the volume to behind the eye, across w = 0",
     [](const SceneOptions& options) { return soup_scene({.crossing_w0 = 1}, options); }},
    {"soup_several_planes",
     "random triangles across two planes or more, half of them behind the eye",
     [](const SceneOptions& options) { return soup_scene({.several_planes = 1}, options); }},
    {"slivers", "needles, near-collinear and near-planar triangles, edges of 1e-4 to 1e6",
     make_slivers_scene},
};

}  // namespace

std::span<const SceneInfo> builtin_scenes() { return kScenes; }

Scene make_builtin_scene(std::string_view name, const SceneOptions& options) {
  const auto info = std::ranges::find(kScenes, name, &SceneInfo::name);
  if (info == std::end(kScenes)) {
    std::vector<std::string_view> names;
    std::ranges::transform(kScenes, std::back_inserter(names), &SceneInfo::name);
    throw UsageError(fmt::format(
        "unknown scene '{}'; there are {}, or give a mesh file (.obj, .ply, .stl, .gltf, .glb)",
        name, fmt::join(names, ", ")));
  }
  Scene scene = info->make(options);
  scene.name = info->name;
  scene.description = info->description;
  return scene;
}

std::uint32_t add_vertex(Mesh& mesh, const glm::dvec3& position,
                         const std::array<double, kSceneAttributes>& attributes) {
  const auto& [u, v, a, b] = attributes;
  mesh.positions.push_back(rounded(position));
  mesh.attributes.push_back({float(u), float(v), float(a), float(b)});
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

void add_random_triangle(Mesh& mesh, const std::array<glm::dvec3, 3>& corners, Random& random) {
  auto& triangle = mesh.triangles.emplace_back();
  for (std::size_t i = 0; i < 3; ++i) {
    const double u = random.uniform(), v = random.uniform();
    const double a = random.uniform(-1, 1), b = random.uniform(-1, 1);
    triangle[i] = add_vertex(mesh, corners[i], {u, v, a, b});
  }
}

void add_grid(Mesh& mesh, std::size_t first, int columns, int rows, bool mirrored) {
  const auto& p = mesh.positions;
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (p[a] == p[b] || p[b] == p[c] || p[c] == p[a]) return;
    mesh.triangles.push_back(mirrored ? std::array{a, c, b} : std::array{a, b, c});
  };
  const auto width = static_cast<std::uint32_t>(columns) + 1;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const auto a = static_cast<std::uint32_t>(first + static_cast<std::size_t>(j) * width +
                                                static_cast<std::size_t>(i));
      add(a, a + 1, a + width + 1);
      add(a, a + width + 1, a + width);
    }
  }
}

void add_sheet(Mesh& mesh, const Sheet& sheet) {
  const auto& c = sheet.corners;
  const std::size_t first = mesh.positions.size();
  for (int j = 0; j <= sheet.rows; ++j) {
    for (int i = 0; i <= sheet.columns; ++i) {
      const double s = double(i) / sheet.columns, t = double(j) / sheet.rows;
      const glm::dvec3 lower = c[0] * (1 - s) + c[1] * s, upper = c[3] * (1 - s) + c[2] * s;
      add_vertex(mesh, lower * (1 - t) + upper * t,
                 {s * sheet.u_tiles, t * sheet.v_tiles, 2 * s - 1, 2 * t - 1});
    }
  }
  add_grid(mesh, first, sheet.columns, sheet.rows);
}

Sheet ground(double side, int quads, double tiles) {
  const double h = side / 2;
  return {{{{-h, 0, h}, {h, 0, h}, {h, 0, -h}, {-h, 0, -h}}}, quads, quads, tiles, tiles};
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

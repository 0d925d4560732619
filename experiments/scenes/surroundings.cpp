// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scenes of few large triangles that surround the eye: the checkerboard floor and the corridor.
#include "experiments/scenes/builtin.hpp"
#include "experiments/scenes/families.hpp"

namespace clipscope::experiments {

Scene make_floor_scene(const SceneOptions& options) {
  constexpr double kHalf = 1000;
  const int quads = options.quick ? 4 : 10;
  Scene scene;
  // One tile per unit of length.
  add_sheet(scene.mesh,
            {.corners =
                 {{{-kHalf, 0, kHalf}, {kHalf, 0, kHalf}, {kHalf, 0, -kHalf}, {-kHalf, 0, -kHalf}}},
             .columns = quads,
             .rows = quads,
             .u_tiles = 2 * kHalf,
             .v_tiles = 2 * kHalf});
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

Scene make_corridor_scene(const SceneOptions& options) {
  constexpr double kWidth = 1.2, kHeight = 2.5, kHalfLength = 100;
  const int strips = options.quick ? 4 : 20;
  Scene scene;
  const glm::dvec3 a(-kWidth, 0, kHalfLength), b(kWidth, 0, kHalfLength);
  const glm::dvec3 c(kWidth, kHeight, kHalfLength), d(-kWidth, kHeight, kHalfLength);
  const glm::dvec3 away(0, 0, -2 * kHalfLength);
  // Each wall is cut along its length only, so that every triangle is as long as the corridor.
  for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, d}, {d, a}}) {
    add_sheet(scene.mesh, {.corners = {{from, to, to + away, from + away}},
                           .columns = strips,
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

}  // namespace clipscope::experiments

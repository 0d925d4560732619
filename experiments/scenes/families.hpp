// SPDX-License-Identifier: GPL-3.0-or-later
//
// The makers of the built-in scenes, one .cpp per family; `builtin.cpp` names and lists them.
//
// Each returns its mesh and views; name and description are filled in by the caller.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

struct SceneOptions;

Scene make_teapot_scene(const SceneOptions&);
Scene make_floor_scene(const SceneOptions&);
Scene make_corridor_scene(const SceneOptions&);
Scene make_terrain_scene(const SceneOptions&);
Scene make_game_soup_scene(const SceneOptions&);
Scene make_inside_soup_scene(const SceneOptions&);
Scene make_outside_soup_scene(const SceneOptions&);
Scene make_straddling_soup_scene(const SceneOptions&);
Scene make_behind_soup_scene(const SceneOptions&);
Scene make_slivers_scene(const SceneOptions&);

// The Utah teapot with `segments` x `segments` quads per patch, standing on y = 0, the spout towards
// +x. Triangles that collapse at the poles of lid and bottom are left out.
// Pre-condition: segments >= 1.
Mesh teapot_mesh(int segments);

// The terrain with 2^levels x 2^levels quads over the same ground, two triangles each.
// Pre-condition: levels >= 1.
Scene terrain_of_levels(int levels, std::uint64_t seed);

// Adds a vertex rounded to float and yields its index.
std::uint32_t add_vertex(Mesh& mesh, const glm::dvec3& position,
                         const std::array<double, kSceneAttributes>& attributes);

// Adds `columns` x `rows` quads between four corners in counter-clockwise order, two triangles each.
// u goes from 0 to u_tiles along corners 0-1, v from 0 to v_tiles along corners 0-3; the two other
// attributes go from -1 to 1 the same way.
struct Sheet {
  std::array<glm::dvec3, 4> corners;
  int columns = 1, rows = 1;
  double u_tiles = 1, v_tiles = 1;
};
void add_sheet(Mesh& mesh, const Sheet& sheet);

// A view that looks from eye to target with +y up, 60 degrees high and 16:9 wide.
View make_view(std::string label, const glm::dvec3& eye, const glm::dvec3& target, double near,
               double far);

// The one view of scenes that are made in view space: 60 degrees, 16:9, near 0.1, far 1000.
View identity_view();

}  // namespace clipscope::experiments

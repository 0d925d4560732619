// SPDX-License-Identifier: GPL-3.0-or-later
//
// The scenes that clipscope ships: small, seeded, and made of code alone; and what they are made
// of, for scenes elsewhere. The table in builtin.cpp names them, one .cpp per family makes them.
//
// A scene is the same bit for bit for the same options.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>

#include "experiments/scenes/random.hpp"
#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

struct SceneOptions {
  std::uint64_t seed = 1;  // of the scenes that are random
  bool quick = false;      // about a quarter of the triangles
};

struct SceneInfo {
  std::string_view name, description;
  Scene (*make)(const SceneOptions&);  // leaves name and description to make_builtin_scene
};

// In the order in which they are shown.
std::span<const SceneInfo> builtin_scenes();

// Errors: UsageError for an unknown name, listing the known ones.
Scene make_builtin_scene(std::string_view name, const SceneOptions& options);

Scene make_slivers_scene(const SceneOptions& options);

// The Utah teapot with `segments` x `segments` quads per patch, standing on y = 0, the spout
// towards +x. Triangles that collapse at the poles of lid and bottom are left out.
// Pre-condition: segments >= 1.
Mesh teapot_mesh(int segments);

// The terrain with 2^levels x 2^levels quads over the same ground, two triangles each.
// Pre-condition: levels >= 1.
Scene terrain_of_levels(int levels, std::uint64_t seed);

// Triangle soups: random view-space triangles in chosen shares of inside, outside and straddling.
//
// What is guaranteed: the shares (exact up to rounding to whole triangles), and that every vertex
// keeps a distance from every plane of the volume and from w = 0 that is more than 1e-5 of its own
// magnitude, so that a float computation classifies it as exact arithmetic does.
// What is not: that the sizes follow any particular game. An inside triangle is 1 to 100 px large
// at 3840 x 2160, a straddling one 16 to 400 px; near-plane crossers are as large as the near
// rectangle; those across several planes are a half to four times as large as their distance from
// the eye (in a parallel projection as half the height of the volume).

// How many of the triangles are of which kind, as non-negative weights of any positive sum.
struct SoupShares {
  double inside = 0;       // all vertices inside the volume
  double outside = 0;      // all vertices outside one plane: rejected by outcodes
  double straddling = 0;   // one vertex or two inside, and every one in front of the eye (w > 0)
  double crossing_w0 = 0;  // one vertex or two inside, and one or two behind the eye (w < 0)
  // Some vertex outside of each of two planes or more, all vertices outside of none. One half of
  // these reach behind the eye with one vertex or two; in a parallel projection none do.
  double several_planes = 0;
};

// several_planes: those in front of the eye; several_planes_behind: the other half. A triangle may
// belong to one of these and to straddling or crossing_w0 as well.
enum class SoupClass {
  inside,
  outside,
  straddling,
  crossing_w0,
  several_planes,
  several_planes_behind
};

// By a plain double computation; false where a vertex comes too close to a plane. In a parallel
// projection nothing crosses w = 0.
bool is_of_class(SoupClass kind, const Frustum<float>& frustum,
                 const std::array<std::array<float, 3>, 3>& triangle);

// `triangles` triangles with three vertices of their own each, the classes in random order.
// Attributes: those of add_random_triangle.
// Errors: UsageError for a negative share, shares that sum to 0, crossing_w0 > 0 with a parallel
// projection, and a volume so thin that a million proposals of a class found no triangle.
// Pre-condition: is_valid(frustum).
Mesh make_soup(const SoupShares& shares, std::size_t triangles, std::uint64_t seed,
               const Frustum<float>& frustum);

// A position rounded to float.
inline std::array<float, 3> rounded(const glm::dvec3& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

// Adds a vertex rounded to float and yields its index.
std::uint32_t add_vertex(Mesh& mesh, const glm::dvec3& position,
                         const std::array<double, kSceneAttributes>& attributes);

// Adds a triangle with vertices of its own and random attributes: u, v in [0, 1), the two others in
// [-1, 1).
void add_random_triangle(Mesh& mesh, const std::array<glm::dvec3, 3>& corners, Random& random);

// Adds the triangles of `columns` x `rows` quads whose vertices are those of the mesh from `first`
// on, row by row: (a, b, c) and (a, c, d) of a quad a, b = a + 1, c, d in turn, or `mirrored`.
// Triangles that have two corners at one place are left out.
void add_grid(Mesh& mesh, std::size_t first, int columns, int rows, bool mirrored = false);

// Adds `columns` x `rows` quads between four corners in counter-clockwise order, two triangles
// each. u goes from 0 to u_tiles along corners 0-1, v from 0 to v_tiles along corners 0-3; the two
// other attributes go from -1 to 1 the same way.
struct Sheet {
  std::array<glm::dvec3, 4> corners;
  int columns = 1, rows = 1;
  double u_tiles = 1, v_tiles = 1;
};
void add_sheet(Mesh& mesh, const Sheet& sheet);

// A square of the plane y = 0 around the origin, seen from above.
Sheet ground(double side, int quads, double tiles);

// A view that looks from eye to target with +y up, 60 degrees high and 16:9 wide.
View make_view(std::string label, const glm::dvec3& eye, const glm::dvec3& target, double near,
               double far);

// The one view of scenes that are made in view space: 60 degrees, 16:9, near 0.1, far 1000.
View identity_view();

}  // namespace clipscope::experiments

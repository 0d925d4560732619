// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scenes whose shared edges are cut in every way: meshes seen so that every plane cuts them, and
// edges made to graze a plane.
#pragma once

#include <cstddef>
#include <cstdint>

#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments::watertight {

// The scene's mesh, named "<scene> by plane", in 28 views. The middle of its box lies
//   on one plane, seen from one side and turned by 180 degrees          12 views
//   on the near plane so close to the eye that much is behind it         4
//   where two planes meet: two sides, or a side and near or far         12
// so that edges are cut with either end outside, and neighbours meet different planes.
// Pre-condition: the mesh has a triangle, and its box is more than a point.
Scene cut_by_every_plane(const Scene& scene);

// `pairs` pairs of triangles in view space, named "grazing", where rounding decides on which side
// of a plane a new vertex of the shared edge is. The ends of the edge are random points on a plane,
// up to 2^-12 of their distance off it and at random inside or outside of other planes; one
// triangle reaches far beyond the plane, the other one stays within, so that only one is cut by it.
Scene make_grazing_scene(std::size_t pairs, std::uint64_t seed);

}  // namespace clipscope::experiments::watertight

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Views in which every plane of the volume cuts a mesh, from both of its sides, and every two that meet.
#pragma once

#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

// The scene's mesh, named "<scene> by plane", in 28 views. The middle of its box lies
//   on one plane, seen from one side and turned by 180 degrees          12 views
//   on the near plane so close to the eye that much is behind it         4
//   where two planes meet: two sides, or a side and near or far         12
// so that edges are cut with either end outside, and neighbours meet different planes.
// Pre-condition: the mesh has a triangle, and its box is more than a point.
Scene cut_by_every_plane(const Scene& scene);

}  // namespace clipscope::experiments

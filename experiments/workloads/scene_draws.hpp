// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draw calls of scenes: meshes with a camera that walks through them, so that planes, and the plane
// of the eye, cut what is drawn.
#pragma once

#include <cstddef>
#include <vector>

#include "experiments/drawcalls/driver.hpp"
#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

inline constexpr std::size_t kChunkTriangles = 200;

// Of each view those `most` chunks of kChunkTriangles consecutive triangles that have the most to
// be clipped, as indexed triangles of 256 px: a vertex that triangles share is there once. Clip
// coordinates are those of the float matrix in float arithmetic. Where nothing is clipped there is
// no chunk. "scene/teapot (near plane in the mesh, triangles 400 to 599)".
std::vector<DrawCall> scene_draws(const Scene& scene, const DriverInfo& info, std::size_t most);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much perspective correction a scene's triangles need: their w_max / w_min as they are drawn, and the
// error in texture coordinates without it.
//
// A polygon is drawn as a fan about its first vertex. The largest error of a fan triangle lies on one of
// its edges and has a closed form there (affine_error.hpp), so that nothing is sampled within triangles.
// Does not guarantee: more than the triangles that were sampled of a scene.
#pragma once

#include <span>
#include <vector>

#include "experiments/report/progress.hpp"
#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

// A vertex as the error of texture coordinates sees it.
struct TextureCorner {
  double w = 1, u = 0, v = 0;
};

struct PolygonNeed {
  double ratio = 1;  // w_max / w_min
  double error = 0;  // the largest of |du| and |dv| of the affine answer, in units of u and v
  // The same after each fan triangle was cut into 16 by halving its edges in view space twice.
  double error_split = 0;
};

// Pre-condition: three corners or more, all w > 0.
PolygonNeed need_of(std::span<const TextureCorner> polygon);

// One for each sampled triangle that is visible, in its exact polygon within the volume.
// triangles_per_view: evenly spaced over the mesh; 0: all.
std::vector<PolygonNeed> scene_needs(const Scene& scene, std::size_t triangles_per_view,
                                     Progress& progress);

}  // namespace clipscope::experiments

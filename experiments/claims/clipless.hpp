// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two ways to a picture, side by side: cutting every triangle and rasterising what is left, or
// rasterising it uncut by its homogeneous edge functions (Olano and Greer 1997).
//
// Both set up the same planes (depth, 1/w, four attributes) and run the same pixel loop over a bounding
// rectangle, in float. The timed whole is view-space triangles in, picture out.
#pragma once

#include <cstdint>

#include "experiments/measure/statistics.hpp"
#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

struct ClipAndRasterise {
  MedianInterval clipped_ns, clipless_ns;  // per triangle of the scene
  MedianInterval speedup;                  // of doing without cutting; paired by round
  // Pixels covered in one picture and not in the exact one, or the other way round.
  std::int64_t clipped_wrong_px = 0, clipless_wrong_px = 0;
};

// The scene as seen from the view, width * height pixels.
ClipAndRasterise measure_clipless(const Scene& scene, const View& view, int width, int height,
                                  int rounds);

}  // namespace clipscope::experiments

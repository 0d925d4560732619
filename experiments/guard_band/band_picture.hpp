// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures of polygons that reach beyond the screen, scissored by the rasterizer, against exact ones.
#pragma once

#include <cstdint>
#include <optional>

#include "experiments/guard_band/band_clip.hpp"
#include "experiments/pictures/draw_scene.hpp"
#include "experiments/render/heat_map.hpp"

namespace clipscope::experiments {

struct BandDrawing {
  std::optional<GuardBand> band;  // none: full clipping, homogeneous/sutherland_hodgman
  bool snapped = false;           // vertices rounded to 1/256 px, as rasterizers do
};

// The whole scene in float, each triangle clipped as the drawing asks and drawn as a fan.
FrameBuffer draw_in_band(const Scene& scene, const View& view, const PictureSize& size,
                         const BandDrawing& drawing);

struct BandPicture {
  HeatMapCounts counts;  // against the exact picture; errors in texels of a 1024-texel texture
  std::int64_t unlike_full_px =
      0;  // pixels that show another triangle, or another side, than with full
          // clipping of the same vertices
};

BandPicture compare_band(const FrameBuffer& drawn, const FrameBuffer& full,
                         const FrameBuffer& exact);

}  // namespace clipscope::experiments

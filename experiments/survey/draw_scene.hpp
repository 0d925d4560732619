// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures of a scene as a clipper shows it, and as it truly is.
#pragma once

#include "experiments/contestants/contestant.hpp"
#include "experiments/render/rasterizer.hpp"
#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

struct PictureSize {
  int width = 960, height = 540;  // px
};

FrameBuffer draw_with(const Contestant& contestant, const Scene& scene, const View& view,
                      const PictureSize& size);

// Drawn from the exact polygons, each coordinate rounded to double once.
FrameBuffer draw_exact(const Scene& scene, const View& view, const PictureSize& size);

// Errors: UsageError listing the labels if the scene has no such view. An empty label is the first
// one.
const View& find_view(const Scene& scene, std::string_view label);

}  // namespace clipscope::experiments

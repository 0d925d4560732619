// SPDX-License-Identifier: GPL-3.0-or-later
//
// What clipping after the divide shows of surfaces that reach behind the eye, beside what is there.
#pragma once

#include <string>

#include "experiments/pictures/draw_scene.hpp"
#include "experiments/render/heat_map.hpp"
#include "experiments/w_sign/side_by_side.hpp"

namespace clipscope::experiments {

struct EyePicture {
  std::string scene;
  FrameBuffer naive;  // cvv/naive in float
  FrameBuffer exact;
  HeatMapCounts counts;  // naive against exact
};

// One triangle: a corner low on the left, one on the right, and one behind the eye and above.
Scene triangle_behind_the_eye();

// The first view of the scene.
EyePicture draw_eye_picture(const Scene& scene, const PictureSize& size);

// Naive on the left, exact on the right, beneath them what differs. It refers to the picture's buffers.
PanelRow panel_row(const EyePicture& picture);

}  // namespace clipscope::experiments

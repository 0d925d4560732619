// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pairs of pictures beside each other on one sheet, with captions.
#pragma once

#include <span>
#include <string>

#include "experiments/render/image.hpp"
#include "experiments/render/rasterizer.hpp"

namespace clipscope::experiments {

struct PanelRow {
  const FrameBuffer* left = nullptr;
  const FrameBuffer* right = nullptr;
  std::string left_caption, right_caption;  // above the panels; ASCII
  std::string note;                         // beneath the row
};

// Pre-conditions: there is a row, and all buffers have the same size. Errors: see canvas.hpp.
Image side_by_side(std::span<const PanelRow> rows);

}  // namespace clipscope::experiments

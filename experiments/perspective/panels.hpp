// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures of one size in a row, each under its title, the last one a heat map whose scale is beneath.
#pragma once

#include <span>
#include <string>

#include "experiments/render/figure.hpp"

namespace clipscope::experiments {

struct PicturePanel {
  std::string title;  // ASCII
  Image image;
};

// On white. Pre-condition: at least one panel; all images have the same size, at least 320 px wide.
// Throws OutputError if there is no font (see render/canvas.hpp).
Image compose_panels(const std::string& title, std::span<const PicturePanel> panels,
                     const HeatMap& map);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// A canvas for figures: rectangles, images, and text through OpenImageIO and its FreeType.
//
// Coordinates are pixels from the top left. Text needs the font DejaVu Sans (Debian:
// fonts-dejavu-core), Liberation Sans or Droid Sans, and is ASCII: OpenImageIO 2.4 renders no other
// characters rightly, and '?' is drawn for them.
#pragma once

#include <string_view>

#include "experiments/render/image_library.hpp"

namespace clipscope::experiments {

struct Area {
  int x = 0, y = 0, width = 0, height = 0;
};

// What lies beside it is left out.
class Canvas {
 public:
  Canvas(int width, int height, const Rgb& background);

  void fill(const Area& box, const Rgb& colour);
  void outline(const Area& box, const Rgb& colour);         // 1 px, outside the box
  void paste(const Image& image, int x, int y, int scale);  // each pixel becomes scale x scale
  // The text's baseline starts, has its middle or ends at (x, y). Throws OutputError without a
  // font.
  void text(int x, int y, std::string_view text, const TextStyle& style);
  // As text, smaller where it would be wider than max_width, down to half the size.
  void fitted_text(int x, int y, int max_width, std::string_view text, TextStyle style);

  Image image() const;

 private:
  Image pixels_;  // sRGB-encoded
};

// The width of a text in pixels. Throws OutputError without a font.
int text_width(std::string_view text, const TextStyle& style);

}  // namespace clipscope::experiments

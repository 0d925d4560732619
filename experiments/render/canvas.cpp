// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/render/canvas.hpp"

#include <algorithm>

namespace clipscope::experiments {
namespace {

// One '?' for each character that is not printable ASCII.
std::string ascii(std::string_view utf8) {
  std::string s;
  for (const char c : utf8) {
    const auto byte = static_cast<unsigned char>(c);
    const bool continues = (byte & 0xc0u) == 0x80u;
    if (!continues) {
      s += byte >= 0x20 && byte < 0x7f ? c : '?';
    }
  }
  return s;
}

}  // namespace

Canvas::Canvas(int width, int height, const Rgb& background)
    : pixels_(image_library().pixels(width, height)) {
  fill({0, 0, width, height}, background);
}

void Canvas::fill(const Area& box, const Rgb& colour) { pixels_->fill(box, colour); }

void Canvas::outline(const Area& box, const Rgb& colour) {
  fill({box.x - 1, box.y - 1, box.width + 2, 1}, colour);
  fill({box.x - 1, box.y + box.height, box.width + 2, 1}, colour);
  fill({box.x - 1, box.y, 1, box.height}, colour);
  fill({box.x + box.width, box.y, 1, box.height}, colour);
}

void Canvas::paste(const Image& image, int x, int y, int scale) {
  pixels_->paste(image, x, y, scale);
}

void Canvas::text(int x, int y, std::string_view text, const TextStyle& style) {
  pixels_->text(x, y, ascii(text), style);
}

void Canvas::fitted_text(int x, int y, int max_width, std::string_view string, TextStyle style) {
  const int smallest = std::max(1, style.size_px / 2);
  while (style.size_px > smallest && text_width(string, style) > max_width) {
    --style.size_px;
  }
  text(x, y, string, style);
}

Image Canvas::image() const { return pixels_->image(); }

int text_width(std::string_view text, const TextStyle& style) {
  return image_library().text_width(ascii(text), style);
}

}  // namespace clipscope::experiments

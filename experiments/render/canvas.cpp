// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/render/canvas.hpp"

#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <array>

#include "experiments/errors.hpp"

namespace clipscope::experiments {
namespace {

struct FontFamily {
  const char* regular;
  const char* bold;
};

constexpr std::array<FontFamily, 3> kFamilies = {{{"DejaVuSans", "DejaVuSans-Bold"},
                                                  {"LiberationSans-Regular", "LiberationSans-Bold"},
                                                  {"DroidSans", "DroidSans-Bold"}}};

const char* font_name(Weight weight) {
  static const FontFamily* const family = [] {
    const auto* found = std::ranges::find_if(kFamilies, [](const FontFamily& f) {
      return OIIO::ImageBufAlgo::text_size("x", 16, f.regular).defined() &&
             OIIO::ImageBufAlgo::text_size("x", 16, f.bold).defined();
    });
    return found == kFamilies.end() ? nullptr : found;
  }();
  if (family == nullptr) {
    throw OutputError(
        "a figure with text needs the font DejaVu Sans (Debian package fonts-dejavu-core), "
        "Liberation Sans or Droid Sans; OPENIMAGEIO_FONTS may name its folder. An .exr needs none");
  }
  return weight == Weight::bold ? family->bold : family->regular;
}

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

Rgb encoded(const Rgb& linear) {
  return {linear_to_srgb(linear[0]), linear_to_srgb(linear[1]), linear_to_srgb(linear[2])};
}

}  // namespace

Canvas::Canvas(int width, int height, const Rgb& background)
    : pixels_(OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::FLOAT)) {
  fill({0, 0, width, height}, background);
}

void Canvas::fill(const Area& box, const Rgb& colour) {
  const Rgb value = encoded(colour);
  const OIIO::ROI roi(box.x, box.x + box.width, box.y, box.y + box.height, 0, 1, 0, 3);
  OIIO::ImageBufAlgo::fill(pixels_, OIIO::cspan<float>(value.data(), 3),
                           OIIO::roi_intersection(roi, pixels_.roi()), 1);
}

void Canvas::outline(const Area& box, const Rgb& colour) {
  fill({box.x - 1, box.y - 1, box.width + 2, 1}, colour);
  fill({box.x - 1, box.y + box.height, box.width + 2, 1}, colour);
  fill({box.x - 1, box.y, 1, box.height}, colour);
  fill({box.x + box.width, box.y, 1, box.height}, colour);
}

void Canvas::paste(const Image& image, int x, int y, int scale) {
  auto from = image.pixels.begin();
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column, ++from) {
      const Rgb value = encoded(*from);
      for (int i = 0; i < scale * scale; ++i) {
        pixels_.setpixel(x + column * scale + i % scale, y + row * scale + i / scale,
                         OIIO::cspan<float>(value.data(), 3));
      }
    }
  }
}

void Canvas::text(int x, int y, std::string_view text, const TextStyle& style) {
  using OIIO::ImageBufAlgo::TextAlignX;
  const TextAlignX align = style.align == Align::left     ? TextAlignX::Left
                           : style.align == Align::center ? TextAlignX::Center
                                                          : TextAlignX::Right;
  const Rgb value = encoded(style.colour);
  if (!OIIO::ImageBufAlgo::render_text(pixels_, x, y, ascii(text), style.size_px,
                                       font_name(style.weight), OIIO::cspan<float>(value.data(), 3),
                                       align, OIIO::ImageBufAlgo::TextAlignY::Baseline, 0, {}, 1)) {
    throw OutputError("can't draw text: " + pixels_.geterror());
  }
}

void Canvas::fitted_text(int x, int y, int max_width, std::string_view string, TextStyle style) {
  const int smallest = std::max(1, style.size_px / 2);
  while (style.size_px > smallest && text_width(string, style) > max_width) {
    --style.size_px;
  }
  text(x, y, string, style);
}

Image Canvas::image() const {
  Image image{pixels_.spec().width, pixels_.spec().height, {}};
  image.pixels.resize(static_cast<std::size_t>(image.width) * image.height);
  pixels_.get_pixels(OIIO::ROI::All(), OIIO::TypeDesc::FLOAT, image.pixels.data());
  for (Rgb& pixel : image.pixels) {
    pixel = {srgb_to_linear(pixel[0]), srgb_to_linear(pixel[1]), srgb_to_linear(pixel[2])};
  }
  return image;
}

int text_width(std::string_view text, const TextStyle& style) {
  return OIIO::ImageBufAlgo::text_size(ascii(text), style.size_px, font_name(style.weight)).width();
}

}  // namespace clipscope::experiments

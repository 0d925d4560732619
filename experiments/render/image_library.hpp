// SPDX-License-Identifier: GPL-3.0-or-later
//
// What OpenImageIO does for figures: text on pixels, and files.
//
// OpenImageIO brings some 250 shared libraries along, and a program linked with it takes 0.4 s to
// start. So it works behind this interface in a module, openimageio.cpp, which is opened when the
// first picture is drawn.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/render/image.hpp"

namespace clipscope::experiments {

enum class Align : std::uint8_t { left, center, right };
enum class Weight : std::uint8_t { regular, bold };

struct TextStyle {
  int size_px = 16;  // the font's em
  Weight weight = Weight::regular;
  Align align = Align::left;
  Rgb colour = {0, 0, 0};
};

enum class FileFormat : std::uint8_t {
  png,  // 8 bits per channel, sRGB
  exr   // 32-bit floats, compressed without loss
};

// What goes into a file: the values of all channels of a pixel, then the next pixel's, from the top
// left.
struct Raster {
  int width = 0, height = 0;
  std::vector<std::string> channels;
  std::vector<float> values;
};

class ImageLibrary {
 public:
  virtual ~ImageLibrary() = default;
  // Texts are ASCII. Both throw OutputError without a font. The width is in pixels; the image is
  // sRGB-encoded, so that text is blended as screens and browsers do, and what lies beside it is
  // left out.
  virtual int text_width(const std::string& text, const TextStyle& style) const = 0;
  virtual void draw_text(Image& image, int x, int y, const std::string& text,
                         const TextStyle& style) const = 0;
  // What went wrong, if something did.
  virtual std::optional<std::string> write(const std::filesystem::path& path, FileFormat format,
                                           const Raster& raster,
                                           const std::string& title) const = 0;
  // The bytes of a WebP file with the same pixels as the PNG. Throws OutputError.
  virtual std::string lossless_webp(const std::filesystem::path& png) const = 0;
};

// Throws OutputError if the module can't be opened.
const ImageLibrary& image_library();

// What the module exports.
extern "C" const ImageLibrary* clipscope_image_library();

}  // namespace clipscope::experiments

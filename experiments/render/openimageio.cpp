// SPDX-License-Identifier: GPL-3.0-or-later
//
// The module that is linked with OpenImageIO; see image_library.hpp.
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>

#include "experiments/errors.hpp"
#include "experiments/render/image_library.hpp"

namespace clipscope::experiments {
namespace {

struct FontFamily {
  const char* regular;
  const char* bold;
};

constexpr std::array<FontFamily, 3> kFamilies = {{{"DejaVuSans", "DejaVuSans-Bold"},
                                                  {"LiberationSans-Regular", "LiberationSans-Bold"},
                                                  {"DroidSans", "DroidSans-Bold"}}};

// Where Debian has them: two folders down, and from version 2.5 on the library looks one down only.
constexpr const char* kFontFolders =
    "/usr/share/fonts/truetype/dejavu:/usr/share/fonts/truetype/liberation:"
    "/usr/share/fonts/truetype/droid";

const char* font_name(Weight weight) {
  static const FontFamily* const family = [] {
    OIIO::attribute("font_searchpath", kFontFolders);
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

Rgb encoded(const Rgb& linear) {
  return {linear_to_srgb(linear[0]), linear_to_srgb(linear[1]), linear_to_srgb(linear[2])};
}

// sRGB-encoded: text is blended as screens and browsers do.
class OiioPixels final : public Pixels {
 public:
  OiioPixels(int width, int height)
      : pixels_(OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::FLOAT)) {}

  void fill(const Area& box, const Rgb& colour) override {
    const Rgb value = encoded(colour);
    const OIIO::ROI roi(box.x, box.x + box.width, box.y, box.y + box.height, 0, 1, 0, 3);
    OIIO::ImageBufAlgo::fill(pixels_, OIIO::cspan<float>(value.data(), 3),
                             OIIO::roi_intersection(roi, pixels_.roi()), 1);
  }

  void paste(const Image& image, int x, int y, int scale) override {
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

  void text(int x, int y, const std::string& text, const TextStyle& style) override {
    using OIIO::ImageBufAlgo::TextAlignX;
    const TextAlignX align = style.align == Align::left     ? TextAlignX::Left
                             : style.align == Align::center ? TextAlignX::Center
                                                            : TextAlignX::Right;
    const Rgb value = encoded(style.colour);
    if (!OIIO::ImageBufAlgo::render_text(pixels_, x, y, text, style.size_px,
                                         font_name(style.weight),
                                         OIIO::cspan<float>(value.data(), 3), align,
                                         OIIO::ImageBufAlgo::TextAlignY::Baseline, 0, {}, 1)) {
      throw OutputError("can't draw text: " + pixels_.geterror());
    }
  }

  Image image() const override {
    Image image{pixels_.spec().width, pixels_.spec().height, {}};
    image.pixels.resize(static_cast<std::size_t>(image.width) * image.height);
    pixels_.get_pixels(OIIO::ROI::All(), OIIO::TypeDesc::FLOAT, image.pixels.data());
    for (Rgb& pixel : image.pixels) {
      pixel = {srgb_to_linear(pixel[0]), srgb_to_linear(pixel[1]), srgb_to_linear(pixel[2])};
    }
    return image;
  }

 private:
  OIIO::ImageBuf pixels_;
};

OIIO::ImageSpec spec_of(FileFormat format, const Raster& raster) {
  const bool png = format == FileFormat::png;
  OIIO::ImageSpec spec(raster.width, raster.height, static_cast<int>(raster.channels.size()),
                       png ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
  spec.channelnames = raster.channels;
  if (png) {
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("png:filter", 8);  // none: figures are 14 % smaller without
  } else {
    spec.attribute("compression", "zip");
  }
  return spec;
}

class Oiio final : public ImageLibrary {
 public:
  std::unique_ptr<Pixels> pixels(int width, int height) const override {
    return std::make_unique<OiioPixels>(width, height);
  }

  int text_width(const std::string& text, const TextStyle& style) const override {
    return OIIO::ImageBufAlgo::text_size(text, style.size_px, font_name(style.weight)).width();
  }

  std::optional<std::string> write(const std::filesystem::path& path, FileFormat format,
                                   const Raster& raster, const std::string& title) const override {
    const std::unique_ptr<OIIO::ImageOutput> output =
        OIIO::ImageOutput::create(format == FileFormat::png ? "png" : "openexr");
    if (!output) return OIIO::geterror();
    OIIO::ImageSpec spec = spec_of(format, raster);
    spec.attribute("ImageDescription", title);
    spec.attribute("Software", "clipscope");
    const bool written = output->open(path.string(), spec) &&
                         output->write_image(OIIO::TypeDesc::FLOAT, raster.values.data()) &&
                         output->close();
    if (written) return std::nullopt;
    return output->geterror();
  }
};

}  // namespace

extern "C" const ImageLibrary* clipscope_image_library() {
  static const Oiio library;
  return &library;
}

}  // namespace clipscope::experiments

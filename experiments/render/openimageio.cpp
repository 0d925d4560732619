// SPDX-License-Identifier: GPL-3.0-or-later
//
// The module that is linked with OpenImageIO; see image_library.hpp. WebP comes from libwebp
// itself: the writer of OpenImageIO 2.4 knows no lossless form of it.
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <webp/encode.h>

#include <algorithm>
#include <array>

#include "experiments/machine/errors.hpp"
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
    "/usr/share/fonts/truetype/dejavu:/usr/share/fonts/truetype/liberation:/usr/share/fonts/truetype/droid";

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
        "a figure with text needs the font DejaVu Sans (Debian package fonts-dejavu-core), Liberation Sans or Droid Sans; OPENIMAGEIO_FONTS may name its folder. An .exr needs none");
  }
  return weight == Weight::bold ? family->bold : family->regular;
}

class Oiio final : public ImageLibrary {
 public:
  int text_width(const std::string& text, const TextStyle& style) const override {
    return OIIO::ImageBufAlgo::text_size(text, style.size_px, font_name(style.weight)).width();
  }

  void draw_text(Image& image, int x, int y, const std::string& text,
                 const TextStyle& style) const override {
    using OIIO::ImageBufAlgo::TextAlignX;
    const TextAlignX align = style.align == Align::left     ? TextAlignX::Left
                             : style.align == Align::center ? TextAlignX::Center
                                                            : TextAlignX::Right;
    const Rgb colour = encoded(style.colour);
    OIIO::ImageBuf pixels(OIIO::ImageSpec(image.width, image.height, 3, OIIO::TypeDesc::FLOAT),
                          image.pixels.data());
    if (!OIIO::ImageBufAlgo::render_text(pixels, x, y, text, style.size_px, font_name(style.weight),
                                         OIIO::cspan<float>(colour.data(), 3), align,
                                         OIIO::ImageBufAlgo::TextAlignY::Baseline, 0, {}, 1)) {
      throw OutputError("can't draw text: " + pixels.geterror());
    }
  }

  std::optional<std::string> write(const std::filesystem::path& path, FileFormat format,
                                   const Raster& raster, const std::string& title) const override {
    const bool png = format == FileFormat::png;
    const auto output = OIIO::ImageOutput::create(png ? "png" : "openexr");
    if (!output) return OIIO::geterror();
    OIIO::ImageSpec spec(raster.width, raster.height, static_cast<int>(raster.channels.size()),
                         png ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
    spec.channelnames = raster.channels;
    if (png) {
      spec.attribute("oiio:ColorSpace", "sRGB");
      spec.attribute("png:filter", 8);  // none: figures are 14 % smaller without
    } else {
      spec.attribute("compression", "zip:1");  // quick rather than smallest
    }
    spec.attribute("ImageDescription", title);
    spec.attribute("Software", "clipscope");
    const bool written = output->open(path.string(), spec) &&
                         output->write_image(OIIO::TypeDesc::FLOAT, raster.values.data()) &&
                         output->close();
    if (written) return std::nullopt;
    return output->geterror();
  }

  std::string lossless_webp(const std::filesystem::path& png) const override {
    const auto input = OIIO::ImageInput::open(png.string());
    if (!input) throw OutputError(OIIO::geterror());
    const int width = input->spec().width, height = input->spec().height;
    std::vector<std::uint8_t> pixels(3 * static_cast<std::size_t>(width) *
                                     static_cast<std::size_t>(height));
    if (!input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, pixels.data())) {
      throw OutputError(input->geterror());
    }
    std::uint8_t* encoded = nullptr;
    const std::size_t size =
        WebPEncodeLosslessRGB(pixels.data(), width, height, 3 * width, &encoded);
    const std::string bytes(reinterpret_cast<const char*>(encoded), size);
    WebPFree(encoded);
    if (size == 0) throw OutputError(png.string() + ": can't be encoded as WebP");
    return bytes;
  }
};

}  // namespace

extern "C" const ImageLibrary* clipscope_image_library() {
  static const Oiio library;
  return &library;
}

}  // namespace clipscope::experiments

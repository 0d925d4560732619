// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writing a figure: PNG for the eye, EXR for further work. See figure.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <system_error>

#include "experiments/machine/errors.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/render/figure.hpp"
#include "experiments/render/image_library.hpp"
#include "experiments/render/webp.hpp"

namespace clipscope::experiments {
namespace {

namespace fs = std::filesystem;

Raster png_raster(const Image& image) {
  Raster r{image.width, image.height, {"R", "G", "B"}, {}};
  r.values.reserve(image.pixels.size() * 3);
  for (const Rgb& pixel : image.pixels) {
    for (const float channel : pixel) {
      r.values.push_back(std::clamp(linear_to_srgb(channel), 0.0f, 1.0f));
    }
  }
  return r;
}

Raster exr_raster(const Figure& figure, const Image& picture) {
  const FrameBuffer& b = *figure.tested;
  const HeatMap* map = figure.heat_map;
  Raster r{picture.width,
           picture.height,
           {"R", "G", "B", "depth", "inv_w", "u", "v", "facing", "triangle"},
           {}};
  if (map != nullptr) {
    r.channels.insert(r.channels.end(), {"heat.R", "heat.G", "heat.B", "error", "fate"});
  }
  r.values.reserve(b.pixels() * r.channels.size());
  const auto add = [&](auto... values) { (r.values.push_back(static_cast<float>(values)), ...); };
  const auto add_rgb = [&](const Rgb& colour) { add(colour[0], colour[1], colour[2]); };
  for (std::size_t p = 0; p < b.pixels(); ++p) {
    const int facing = b.facing[p] == Facing::none ? 0 : b.facing[p] == Facing::front ? 1 : -1;
    add_rgb(picture.pixels[p]);
    add(b.depth[p], b.inv_w[p], b.attributes[p][0], b.attributes[p][1], facing,
        b.triangle[p] == kNoTriangle ? -1.0 : static_cast<double>(b.triangle[p]));
    if (map == nullptr) continue;
    add_rgb(map->image.pixels[p]);
    add(map->error[p], static_cast<int>(map->fate[p]));
  }
  return r;
}

// Under another name first, so that the file appears complete or not at all.
void write(const fs::path& path, FileFormat format, const Raster& raster,
           const std::string& title) {
  const fs::path partial = path.string() + ".partial";
  std::optional<std::string> wrong = image_library().write(partial, format, raster, title);
  std::error_code error;
  if (!wrong) fs::rename(partial, path, error);
  if (error) wrong = error.message();
  if (!wrong) return;
  fs::remove(partial, error);
  throw OutputError(fmt::format("can't write {}: {}", path.string(), *wrong));
}

}  // namespace

void check_image_path(const fs::path& path) {
  const std::string extension = extension_of(path);
  if (extension != ".png" && extension != ".exr") {
    throw UsageError(
        fmt::format("--out {}: the extension must be .png (a figure) or .exr (the data per pixel)",
                    path.string()));
  }
}

void write_image(const fs::path& path, const Figure& figure) {
  check_image_path(path);
  const FigureTitles& t = figure.titles;
  const std::string title = fmt::format("{}: {}, {}", t.scene, t.clipper, t.scalar);
  if (extension_of(path) == ".png") {
    write_png(path, compose(figure), title);
  } else {
    write(path, FileFormat::exr, exr_raster(figure, shade(*figure.tested, figure.picture)), title);
  }
}

void write_png(const fs::path& path, const Image& image, const std::string& title) {
  write(path, FileFormat::png, png_raster(image), title);
}

std::string lossless_webp(const fs::path& png) { return image_library().lossless_webp(png); }

}  // namespace clipscope::experiments

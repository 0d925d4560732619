// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writing a figure: PNG for the eye, EXR for further work. See figure.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <system_error>
#include <utility>

#include "experiments/errors.hpp"
#include "experiments/render/figure.hpp"
#include "experiments/render/image_library.hpp"

namespace clipscope::experiments {
namespace {

namespace fs = std::filesystem;

std::string lower_extension(const fs::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

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

struct Channel {
  std::string name;
  std::function<double(std::size_t)> value;  // of a pixel
};

void add_rgb(std::vector<Channel>& channels, const std::string& prefix, const Image& image) {
  for (int i = 0; i < 3; ++i) {
    channels.push_back({prefix + "RGB"[i], [&image, i](std::size_t p) -> double {
                          return image.pixels[p][static_cast<std::size_t>(i)];
                        }});
  }
}

void add_buffer(std::vector<Channel>& channels, const FrameBuffer& b) {
  channels.push_back({"depth", [&b](std::size_t p) -> double { return b.depth[p]; }});
  channels.push_back({"inv_w", [&b](std::size_t p) { return b.inv_w[p]; }});
  channels.push_back({"u", [&b](std::size_t p) { return b.attributes[p][0]; }});
  channels.push_back({"v", [&b](std::size_t p) { return b.attributes[p][1]; }});
  channels.push_back({"facing", [&b](std::size_t p) {
                        const double sign = b.facing[p] == Facing::front ? 1 : -1;
                        return b.covered(p) ? sign : 0.0;
                      }});
  channels.push_back({"triangle", [&b](std::size_t p) {
                        return b.triangle[p] == kNoTriangle ? -1.0
                                                            : static_cast<double>(b.triangle[p]);
                      }});
}

Raster exr_raster(const Figure& figure, const Image& picture) {
  std::vector<Channel> channels;
  add_rgb(channels, "", picture);
  add_buffer(channels, *figure.tested);
  if (const HeatMap* map = figure.heat_map; map != nullptr) {
    add_rgb(channels, "heat.", map->image);
    channels.push_back({"error", [map](std::size_t p) { return map->error[p]; }});
    channels.push_back(
        {"fate", [map](std::size_t p) { return static_cast<double>(map->fate[p]); }});
  }
  Raster r{picture.width, picture.height, {}, {}};
  for (const Channel& channel : channels) {
    r.channels.push_back(channel.name);
  }
  r.values.reserve(picture.pixels.size() * channels.size());
  for (std::size_t p = 0; p < picture.pixels.size(); ++p) {
    for (const Channel& channel : channels) {
      r.values.push_back(static_cast<float>(channel.value(p)));
    }
  }
  return r;
}

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
  throw OutputError(fmt::format("can't write {}: {}", path.string(), reason));
}

// A file name that is removed again unless it was renamed to its final one.
class PartialFile {
 public:
  explicit PartialFile(const fs::path& final_path)
      : final_path_(final_path), path_(final_path.string() + ".partial") {}
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;
  ~PartialFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }

  const fs::path& path() const { return path_; }
  void rename() const {
    std::error_code error;
    fs::rename(path_, final_path_, error);
    if (error) {
      fail(final_path_, error.message());
    }
  }

 private:
  fs::path final_path_, path_;
};

void write(const fs::path& path, FileFormat format, const Raster& raster,
           const std::string& title) {
  const PartialFile partial(path);
  if (const auto wrong = image_library().write(partial.path(), format, raster, title)) {
    fail(path, *wrong);
  }
  partial.rename();
}

}  // namespace

void check_image_path(const fs::path& path) {
  const std::string extension = lower_extension(path);
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
  if (lower_extension(path) == ".png") {
    write_png(path, compose(figure), title);
  } else {
    write(path, FileFormat::exr, exr_raster(figure, shade(*figure.tested, figure.picture)), title);
  }
}

void write_png(const fs::path& path, const Image& image, const std::string& title) {
  write(path, FileFormat::png, png_raster(image), title);
}

}  // namespace clipscope::experiments

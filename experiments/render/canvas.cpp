// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/render/canvas.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>

#include "experiments/machine/errors.hpp"

namespace clipscope::experiments {
namespace {

namespace fs = std::filesystem;

// Beside an installed program, else where the build has put it.
fs::path module_path() {
  const fs::path program = fs::read_symlink("/proc/self/exe");
  const fs::path installed = program.parent_path() / CLIPSCOPE_INSTALLED_MODULE;
  return fs::exists(installed) ? installed : fs::path(CLIPSCOPE_BUILT_MODULE);
}

const ImageLibrary& open_module() {
  void* const module = dlopen(module_path().c_str(), RTLD_LAZY | RTLD_LOCAL);
  void* const entry = module != nullptr ? dlsym(module, "clipscope_image_library") : nullptr;
  if (entry == nullptr) {
    throw OutputError(
        fmt::format("pictures need OpenImageIO, and its module can't be opened: {}", dlerror()));
  }
  return *reinterpret_cast<decltype(&clipscope_image_library)>(entry)();
}

// One '?' for each character that is not printable ASCII.
std::string ascii(std::string_view utf8) {
  std::string s;
  for (const char c : utf8) {
    const auto byte = static_cast<unsigned char>(c);
    const bool continues = (byte & 0xc0u) == 0x80u;
    if (!continues) s += byte >= 0x20 && byte < 0x7f ? c : '?';
  }
  return s;
}

}  // namespace

const ImageLibrary& image_library() {
  static const ImageLibrary& library = open_module();
  return library;
}

Canvas::Canvas(int width, int height, const Rgb& background) : pixels_{width, height, {}} {
  pixels_.pixels.assign(static_cast<std::size_t>(width) * height, encoded(background));
}

void Canvas::fill(const Area& box, const Rgb& colour) {
  const Rgb value = encoded(colour);
  const int right = std::min(box.x + box.width, pixels_.width);
  const int bottom = std::min(box.y + box.height, pixels_.height);
  for (int y = std::max(box.y, 0); y < bottom; ++y) {
    for (int x = std::max(box.x, 0); x < right; ++x) {
      pixels_.pixels[static_cast<std::size_t>(y) * pixels_.width + x] = value;
    }
  }
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
    for (int column = 0; column < image.width; ++column) {
      fill({x + column * scale, y + row * scale, scale, scale}, *from++);
    }
  }
}

void Canvas::text(int x, int y, std::string_view text, const TextStyle& style) {
  image_library().draw_text(pixels_, x, y, ascii(text), style);
}

void Canvas::fitted_text(int x, int y, int max_width, std::string_view string, TextStyle style) {
  const int smallest = std::max(1, style.size_px / 2);
  while (style.size_px > smallest && text_width(string, style) > max_width) --style.size_px;
  text(x, y, string, style);
}

Image Canvas::image() const {
  Image image = pixels_;
  for (Rgb& pixel : image.pixels) {
    for (float& channel : pixel) channel = srgb_to_linear(channel);
  }
  return image;
}

int text_width(std::string_view text, const TextStyle& style) {
  return image_library().text_width(ascii(text), style);
}

}  // namespace clipscope::experiments

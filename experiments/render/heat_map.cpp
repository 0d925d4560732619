// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/render/heat_map.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace clipscope::experiments {
namespace {

constexpr double kTextureSize = 1024;

// The first 8 of 10 equidistant samples of viridis, sRGB.
constexpr std::array<std::uint32_t, 8> kScale = {0x440154, 0x482878, 0x3e4a89, 0x31688e,
                                                 0x26828e, 0x1f9e89, 0x35b779, 0x6dcd59};

// In the order of PixelFate.
constexpr std::array<std::uint32_t, kPixelFates> kFateColours = {
    0x34363a, 0x000000, 0x000000, 0xff00ff, 0x00ffff, 0xffff00, 0xff2a00};

double error_between(const FrameBuffer& tested, const FrameBuffer& truth, std::size_t pixel) {
  const ScreenAttributes &a = tested.attributes[pixel], &b = truth.attributes[pixel];
  return kTextureSize * std::max(std::abs(a[0] - b[0]), std::abs(a[1] - b[1]));
}

// The fate as far as coverage, finiteness and facing decide it; `equal` stands for the rest.
PixelFate fate_before_error(const FrameBuffer& tested, const FrameBuffer& truth,
                            std::size_t pixel) {
  if (!tested.covered(pixel)) return truth.covered(pixel) ? PixelFate::hole : PixelFate::empty;
  if (!truth.covered(pixel)) return PixelFate::extra;
  if (!tested.finite(pixel) || !truth.finite(pixel)) return PixelFate::not_finite;
  return tested.facing[pixel] == truth.facing[pixel] ? PixelFate::equal : PixelFate::flipped;
}

void summarise(HeatMap& map) {
  std::vector<double> errors;
  std::uint64_t above_one = 0;
  for (std::size_t i = 0; i < map.fate.size(); ++i) {
    ++map.counts.pixels[static_cast<std::size_t>(map.fate[i])];
    if (map.fate[i] == PixelFate::equal || map.fate[i] == PixelFate::error) {
      errors.push_back(map.error[i]);
      above_one += map.error[i] > 1;
    }
  }
  if (errors.empty()) return;
  map.counts.max_error = *std::ranges::max_element(errors);
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::ranges::nth_element(errors, middle);
  map.counts.median_error = *middle;
  map.counts.share_above_one = static_cast<double>(above_one) / static_cast<double>(errors.size());
}

// hole, extra, flipped or not_finite.
bool is_signal(PixelFate fate) { return fate >= PixelFate::hole; }

// Paints the signal colours over the 3 x 3 neighbourhood of their pixels. A signal pixel keeps its
// own colour; between neighbours of several fates the first in row order decides.
void dilate_signals(HeatMap& map) {
  const int width = map.image.width, height = map.image.height;
  const auto at = [&](int x, int y) { return static_cast<std::size_t>(y) * width + x; };
  for (int y = height - 1; y >= 0; --y) {
    for (int x = width - 1; x >= 0; --x) {
      if (!is_signal(map.fate[at(x, y)])) continue;
      for (int v = std::max(0, y - 1); v <= std::min(height - 1, y + 1); ++v) {
        for (int u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u) {
          if (!is_signal(map.fate[at(u, v)])) {
            map.image.pixels[at(u, v)] = fate_colour(map.fate[at(x, y)]);
          }
        }
      }
    }
  }
}

}  // namespace

HeatMap compare(const FrameBuffer& tested, const FrameBuffer& truth,
                const HeatMapOptions& options) {
  assert(tested.width == truth.width && tested.height == truth.height);
  assert(tested.depth_range == truth.depth_range);
  HeatMap map{options, {tested.width, tested.height, {}}, {}, {}, {}};
  const std::size_t n = tested.pixels();
  map.image.pixels.resize(n);
  map.fate.resize(n);
  map.error.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    map.fate[i] = fate_before_error(tested, truth, i);
    map.image.pixels[i] = fate_colour(map.fate[i]);
    if (map.fate[i] == PixelFate::equal) {
      map.error[i] = error_between(tested, truth, i);
      if (map.error[i] >= options.lowest) {
        map.fate[i] = PixelFate::error;
        map.image.pixels[i] = error_colour(scale_position(options, map.error[i]));
      }
    }
  }
  summarise(map);
  map.counts.triangles_not_drawn = tested.not_finite;
  if (options.dilate) dilate_signals(map);
  return map;
}

Rgb fate_colour(PixelFate fate) { return from_hex(kFateColours[static_cast<std::size_t>(fate)]); }

Rgb error_colour(double t) {
  const double last = kScale.size() - 1;
  const double s = t > 0 ? std::min(t, 1.0) * last : 0;
  const auto i = std::min(static_cast<std::size_t>(s), kScale.size() - 2);
  return mix(from_hex(kScale[i]), from_hex(kScale[i + 1]),
             static_cast<float>(s - static_cast<double>(i)));
}

double scale_position(const HeatMapOptions& options, double error) {
  return std::log(error / options.lowest) / std::log(options.highest / options.lowest);
}

}  // namespace clipscope::experiments

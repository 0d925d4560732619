// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/render/picture.hpp"

#include <algorithm>
#include <cmath>

namespace clipscope::experiments {
namespace {

// Change per pixel to the right and downwards.
struct Slope {
  double x = 0, y = 0;
};

// Neighbours that show the same side of a surface. Of the two differences along an axis the smaller
// is taken: it is the one that does not cross a silhouette or a crease.
class Neighbourhood {
 public:
  Neighbourhood(const FrameBuffer& buffer, int x, int y)
      : buffer_(buffer), x_(x), y_(y), pixel_(static_cast<std::size_t>(y) * buffer.width + x) {}

  template <class Field>
  Slope slope(const Field& field) const {
    const auto row = static_cast<std::size_t>(buffer_.width);
    return {along(field, 1, x_ > 0, x_ + 1 < buffer_.width),
            along(field, row, y_ > 0, y_ + 1 < buffer_.height)};
  }

 private:
  template <class Field>
  double along(const Field& field, std::size_t step, bool has_before, bool has_after) const {
    const double here = field(pixel_);
    const auto same = [&](std::size_t p) { return buffer_.facing[p] == buffer_.facing[pixel_]; };
    const bool before = has_before && same(pixel_ - step);
    const bool after = has_after && same(pixel_ + step);
    const double backward = before ? here - field(pixel_ - step) : 0;
    const double forward = after ? field(pixel_ + step) - here : 0;
    const bool smaller = before && (!after || std::abs(backward) < std::abs(forward));
    const double change = smaller ? backward : forward;
    return std::isfinite(change) ? change : 0;
  }

  const FrameBuffer& buffer_;
  int x_, y_;
  std::size_t pixel_;
};

// Mean of a square wave (+1 on [0,1), -1 on [1,2), …) over a window of the given width.
double filtered_wave(double x, double width) {
  const auto triangle = [](double t) { return std::abs(t - std::floor(t) - 0.5); };
  return 2 * (triangle((x - 0.5 * width) / 2) - triangle((x + 0.5 * width) / 2)) / width;
}

// Share of light cells in the pixel, 0 to 1.
double checker(const FrameBuffer& buffer, const Neighbourhood& around, std::size_t pixel,
               double cells) {
  double product = 1;
  for (int k = 0; k < 2; ++k) {
    const Slope d = around.slope([&](std::size_t p) { return buffer.attributes[p][k] * cells; });
    const double width = std::max(std::abs(d.x), std::abs(d.y)) + 1e-3;
    product *= filtered_wave(buffer.attributes[pixel][k] * cells, width);
  }
  return std::isfinite(product) ? std::clamp(0.5 + 0.5 * product, 0.0, 1.0) : 0.5;
}

// Light on the surface, 0 to 1. With X = x w and Y = y w the plane a X + b Y + c w = 1 appears as
// 1/w = a x + b y + c: its normal is (a, b, c), scaled by the tangents of half the field of view.
double light(const FrameBuffer& buffer, const Neighbourhood& around, std::size_t pixel) {
  constexpr double kTanHalfHeight = 0.58;
  const double tan_half_width = kTanHalfHeight * buffer.width / buffer.height;
  const double x = (2.0 * (pixel % buffer.width) + 1) / buffer.width - 1;
  const double y = 1 - (2.0 * (pixel / buffer.width) + 1) / buffer.height;
  Slope d = around.slope([&](std::size_t p) { return buffer.inv_w[p]; });
  double scale = std::abs(buffer.inv_w[pixel]);
  if (d.x == 0 && d.y == 0) {
    const double nearer = buffer.depth_range == DepthRange::reversed ? 1 : -1;
    d = around.slope([&](std::size_t p) { return nearer * buffer.depth[p]; });
    scale = 1;
  }
  const double a = d.x * buffer.width / 2, b = -d.y * buffer.height / 2;
  const std::array<double, 3> n = {a / tan_half_width, b / kTanHalfHeight, scale - a * x - b * y};
  const double length = std::hypot(n[0], n[1], n[2]);
  if (!(length > 0) || !std::isfinite(length)) {
    return 1;
  }
  // (a, b, c) points away from the eye, for the plane's form is 0 there; the light is given towards it.
  constexpr std::array<double, 3> kToLight = {-0.42, 0.62, 0.66};  // right, up, to the viewer
  const double cosine = (-n[0] * kToLight[0] - n[1] * kToLight[1] + n[2] * kToLight[2]) / length;
  return 0.5 + 0.5 * cosine;
}

Rgb shade_pixel(const FrameBuffer& buffer, int x, int y, const PictureOptions& options) {
  const auto pixel = static_cast<std::size_t>(y) * buffer.width + x;
  if (!buffer.covered(pixel)) {
    return from_hex(0xe9eaec);
  }
  if (!buffer.finite(pixel)) {
    return {0, 0, 0};
  }
  const bool front = buffer.facing[pixel] == Facing::front;
  const Neighbourhood around(buffer, x, y);
  const auto warmth = static_cast<float>(std::clamp(buffer.attributes[pixel][2], -1.0, 1.0));
  const Rgb dark = front ? mix(from_hex(0x2f5d8c), from_hex(0x3f7f86), 0.5f + 0.5f * warmth)
                         : from_hex(0x8c2f3b);
  const Rgb bright = front ? mix(from_hex(0xf3f6fa), from_hex(0xfaf3e3), 0.5f + 0.5f * warmth)
                           : from_hex(0xf7d9d4);
  const auto share = static_cast<float>(checker(buffer, around, pixel, options.cells_per_unit));
  const auto lit = static_cast<float>(light(buffer, around, pixel));
  return mix({0, 0, 0}, mix(dark, bright, share), 0.35f + 0.65f * lit);
}

}  // namespace

Image shade(const FrameBuffer& buffer, const PictureOptions& options) {
  Image image{buffer.width, buffer.height, {}};
  image.pixels.reserve(buffer.pixels());
  for (int y = 0; y < buffer.height; ++y) {
    for (int x = 0; x < buffer.width; ++x) {
      image.pixels.push_back(shade_pixel(buffer, x, y, options));
    }
  }
  return image;
}

}  // namespace clipscope::experiments

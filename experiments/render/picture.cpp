// SPDX-License-Identifier: GPL-3.0-or-later
//
// The picture that a person looks at: a frame buffer shaded with a checkerboard.
//
// Cells come from texture coordinates u and v, filtered over the pixel (Quilez, "Box filtering a
// checkers pattern", 2013), tinted softly by the third attribute. Light falls from the viewer's
// upper left on the plane that 1/w (in a parallel projection, depth) spans around the pixel. Back
// faces are reddish, so that a flip is seen; pixels without a finite value are black.
// Does not guarantee: photometric truth; the field of view that shading assumes is about 60
// degrees.
#include <algorithm>
#include <cmath>

#include "experiments/render/figure.hpp"

namespace clipscope::experiments {
namespace {

// Change per pixel to the right and downwards.
struct Slope {
  double x = 0, y = 0;
};

struct Pixel {
  const FrameBuffer& buffer;
  int x, y;
  std::size_t index = static_cast<std::size_t>(y) * buffer.width + x;
};

// How field(pixel) changes from a pixel to the next, `step` on, among neighbours that show the same
// side of a surface. The smaller of the two differences is taken: it is the one that does not cross
// a silhouette or a crease.
template <class Field>
double change_along(const Pixel& pixel, std::size_t step, bool has_before, bool has_after,
                    const Field& field) {
  const auto& facing = pixel.buffer.facing;
  const std::size_t here = pixel.index;
  const bool before = has_before && facing[here - step] == facing[here];
  const bool after = has_after && facing[here + step] == facing[here];
  const double backward = before ? field(here) - field(here - step) : 0;
  const double forward = after ? field(here + step) - field(here) : 0;
  const bool smaller = before && (!after || std::abs(backward) < std::abs(forward));
  const double change = smaller ? backward : forward;
  return std::isfinite(change) ? change : 0;
}

template <class Field>
Slope slope_at(const Pixel& p, const Field& field) {
  const int width = p.buffer.width, height = p.buffer.height;
  return {change_along(p, 1, p.x > 0, p.x + 1 < width, field),
          change_along(p, static_cast<std::size_t>(width), p.y > 0, p.y + 1 < height, field)};
}

// Mean of a square wave (+1 on [0,1), -1 on [1,2), …) over a window of the given width.
double filtered_wave(double x, double width) {
  const auto triangle = [](double t) { return std::abs(t - std::floor(t) - 0.5); };
  return 2 * (triangle((x - 0.5 * width) / 2) - triangle((x + 0.5 * width) / 2)) / width;
}

// Share of light cells in the pixel, 0 to 1.
double checker(const Pixel& pixel, double cells) {
  double product = 1;
  for (int k = 0; k < 2; ++k) {
    const auto cell = [&](std::size_t p) { return pixel.buffer.attributes[p][k] * cells; };
    const Slope d = slope_at(pixel, cell);
    const double width = std::max(std::abs(d.x), std::abs(d.y)) + 1e-3;
    product *= filtered_wave(cell(pixel.index), width);
  }
  return std::isfinite(product) ? std::clamp(0.5 + 0.5 * product, 0.0, 1.0) : 0.5;
}

// Light on the surface, 0 to 1. With X = x w and Y = y w the plane a X + b Y + c w = 1 appears as
// 1/w = a x + b y + c: its normal is (a, b, c), scaled by the tangents of half the field of view.
double light(const Pixel& pixel) {
  const FrameBuffer& buffer = pixel.buffer;
  constexpr double kTanHalfHeight = 0.58;
  const double tan_half_width = kTanHalfHeight * buffer.width / buffer.height;
  const double x = (2.0 * pixel.x + 1) / buffer.width - 1;
  const double y = 1 - (2.0 * pixel.y + 1) / buffer.height;
  Slope d = slope_at(pixel, [&](std::size_t p) { return buffer.inv_w[p]; });
  double scale = std::abs(buffer.inv_w[pixel.index]);
  if (d.x == 0 && d.y == 0) {
    const double nearer = buffer.depth_range == DepthRange::reversed ? 1 : -1;
    d = slope_at(pixel, [&](std::size_t p) { return nearer * buffer.depth[p]; });
    scale = 1;
  }
  const double a = d.x * buffer.width / 2, b = -d.y * buffer.height / 2;
  const std::array<double, 3> n = {a / tan_half_width, b / kTanHalfHeight, scale - a * x - b * y};
  const double length = std::hypot(n[0], n[1], n[2]);
  if (!(length > 0) || !std::isfinite(length)) return 1;
  // (a, b, c) points away from the eye, for the plane's form is 0 there; the light is given towards
  // it.
  constexpr std::array<double, 3> kToLight = {-0.42, 0.62, 0.66};  // right, up, to the viewer
  const double cosine = (-n[0] * kToLight[0] - n[1] * kToLight[1] + n[2] * kToLight[2]) / length;
  return 0.5 + 0.5 * cosine;
}

Rgb shade_pixel(const Pixel& pixel, const PictureOptions& options) {
  const FrameBuffer& buffer = pixel.buffer;
  if (!buffer.covered(pixel.index)) return from_hex(0xe9eaec);
  if (!buffer.finite(pixel.index)) return {0, 0, 0};
  const bool front = buffer.facing[pixel.index] == Facing::front;
  const auto warmth = static_cast<float>(std::clamp(buffer.attributes[pixel.index][2], -1.0, 1.0));
  const float tint = 0.5f + 0.5f * warmth;
  const Rgb dark = front ? mix(from_hex(0x2f5d8c), from_hex(0x3f7f86), tint) : from_hex(0x8c2f3b);
  const Rgb bright = front ? mix(from_hex(0xf3f6fa), from_hex(0xfaf3e3), tint) : from_hex(0xf7d9d4);
  const auto share = static_cast<float>(checker(pixel, options.cells_per_unit));
  const auto lit = static_cast<float>(light(pixel));
  return mix({0, 0, 0}, mix(dark, bright, share), 0.35f + 0.65f * lit);
}

}  // namespace

Image shade(const FrameBuffer& buffer, const PictureOptions& options) {
  Image image{buffer.width, buffer.height, {}};
  image.pixels.reserve(buffer.pixels());
  for (int y = 0; y < buffer.height; ++y) {
    for (int x = 0; x < buffer.width; ++x) {
      image.pixels.push_back(shade_pixel({buffer, x, y}, options));
    }
  }
  return image;
}

}  // namespace clipscope::experiments

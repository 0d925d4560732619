// SPDX-License-Identifier: GPL-3.0-or-later
//
// An RGB image in linear light, and the sRGB transfer function (IEC 61966-2-1).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace clipscope::experiments {

// Linear light, 0 is black and 1 is white, Rec. 709 primaries.
using Rgb = std::array<float, 3>;

// width * height pixels, row by row from the top left.
struct Image {
  int width = 0, height = 0;
  std::vector<Rgb> pixels;
};

inline float srgb_to_linear(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

inline float linear_to_srgb(float linear) {
  return linear <= 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

inline Rgb encoded(const Rgb& linear) {
  return {linear_to_srgb(linear[0]), linear_to_srgb(linear[1]), linear_to_srgb(linear[2])};
}

// A colour written as in HTML: 0xrrggbb, sRGB.
inline Rgb from_hex(std::uint32_t rgb) {
  const auto channel = [&](int shift) {
    return srgb_to_linear(static_cast<float>((rgb >> shift) & 0xffu) / 255.0f);
  };
  return {channel(16), channel(8), channel(0)};
}

// a + t (b - a).
inline Rgb mix(const Rgb& a, const Rgb& b, float t) {
  Rgb r;
  for (std::size_t i = 0; i < r.size(); ++i) r[i] = a[i] + t * (b[i] - a[i]);
  return r;
}

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares two frame buffers pixel by pixel: categories, errors with units, counts, and a picture.
//
// Colours: an error is shown on a logarithmic viridis scale (Smith and van der Walt, 2015), whose
// lightness grows with the error, in grey print too. Its brightest fifth is left out and the ground
// is dark, so that the signal colours of categories (magenta, cyan, yellow, red) stay at least 24
// apart in CIELAB from every error and from the ground, also with simulated protanopia,
// deuteranopia and tritanopia (Machado, Oliveira and Fernandes, 2009).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "experiments/render/image.hpp"
#include "experiments/render/rasterizer.hpp"

namespace clipscope::experiments {

// The fate of a pixel of the tested buffer against the truth. One pixel has one fate: the first
// that applies in the order hole, extra, not_finite, flipped; then equal or error. The error is the
// larger of |du| and |dv| in texels of a 1024-texel texture, where both buffers show the same side
// of something.
enum class PixelFate : std::uint8_t {
  empty,       // neither is covered
  equal,       // the error is below the colour scale
  error,       // the error is on the colour scale or above it
  hole,        // truth covered, tested not
  extra,       // tested covered, truth not
  flipped,     // front face instead of back face or the reverse
  not_finite,  // depth or an attribute of either buffer is NaN or infinite
};

inline constexpr int kPixelFates = 7;

struct HeatMapOptions {
  double lowest = 1e-5, highest = 1e3;  // ends of the colour scale, in texels
  bool dilate = true;  // draw holes, extras, flips and not finite pixels 3 px wide; counts are not
};

inline constexpr std::string_view kErrorLabel =
    "texture coordinate error [texels of a 1024-texel texture]";

struct HeatMapCounts {
  std::array<std::uint64_t, kPixelFates> pixels = {};  // by fate; their sum is the buffer's size
  double max_error = 0;        // over pixels whose fate is equal or error; 0 if there are none
  double median_error = 0;     // over the same pixels (the upper one of two)
  double share_above_one = 0;  // the share of them above one texel: 0 to 1

  std::uint64_t triangles_not_drawn = 0;  // of the tested buffer: a vertex is not finite

  std::uint64_t operator[](PixelFate fate) const { return pixels[static_cast<std::size_t>(fate)]; }
  std::uint64_t compared() const { return (*this)[PixelFate::equal] + (*this)[PixelFate::error]; }
};

struct HeatMap {
  HeatMapOptions options;
  Image image;
  std::vector<PixelFate> fate;
  std::vector<double> error;  // in texels; 0 where the fate is neither equal nor error
  HeatMapCounts counts;
};

// Pre-condition: both buffers have the same size and depth range.
HeatMap compare(const FrameBuffer& tested, const FrameBuffer& truth,
                const HeatMapOptions& options = {});

// The colour of a fate; for `error` see error_colour.
Rgb fate_colour(PixelFate fate);

// The colour at t in [0, 1] of the error scale; values outside take the colour of the nearer end.
Rgb error_colour(double t);

// Where an error lies on the scale: log(error/lowest) / log(highest/lowest). May leave [0, 1].
double scale_position(const HeatMapOptions& options, double error);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small shapes in NDC for the tests of the rasterizer and of what follows it.
#pragma once

#include <array>

#include "experiments/render/rasterizer.hpp"

namespace clipscope::experiments {

using Quad = std::array<ScreenVertex, 4>;

// The rectangle [x0, x1] x [y0, y1], a front face at depth 0 with w = 1, u = x and v = y.
inline Quad rectangle(double x0, double y0, double x1, double y1) {
  return {{{x0, y0, 0, 1, {x0, y0}},
           {x1, y0, 0, 1, {x1, y0}},
           {x1, y1, 0, 1, {x1, y1}},
           {x0, y1, 0, 1, {x0, y1}}}};
}

inline const Quad kWholeScreen = rectangle(-1, -1, 1, 1);

inline FrameBuffer empty_buffer(int width, int height) {
  return {width, height, DepthRange::minus_one_to_one};
}

inline int covered_pixels(const FrameBuffer& buffer) {
  int n = 0;
  for (std::size_t i = 0; i < buffer.pixels(); ++i) n += buffer.covered(i);
  return n;
}

}  // namespace clipscope::experiments

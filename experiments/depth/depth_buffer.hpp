// SPDX-License-Identifier: GPL-3.0-or-later
//
// Depth buffers: what is stored for a point so far in front of the eye, by depth convention and format.
//
// The way of a point is that of a renderer: the depth row of the projection matrix, the divide, from
// [-1, 1] to [0, 1] where the convention asks for it, clamping, and rounding to the format. The input is
// a float; everything up to the rounding is done in float or in double.
// Sources: Upchurch and Desbrun, "Tightening the Precision of Perspective Rendering", Journal of Graphics
// Tools 16(1), 2012; Reed, "Depth Precision Visualized", 2015; formats: OpenGL 4.6 specification, 2.3.5.
// Does not guarantee: the bits of a particular GPU, which may convert to a fixed-point format in less
// than double, and may interpolate depth over a triangle first.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "reference/truth.hpp"
#include "spaces/projection.hpp"

namespace clipscope::experiments {

struct DepthConvention {
  std::string_view name;
  DepthRange range;
  bool infinite_far;
};

inline constexpr std::array<DepthConvention, 6> kDepthConventions = {{
    {"gl", DepthRange::minus_one_to_one, false},
    {"gl_infinite", DepthRange::minus_one_to_one, true},
    {"zero_to_one", DepthRange::zero_to_one, false},
    {"zero_to_one_infinite", DepthRange::zero_to_one, true},
    {"reversed", DepthRange::reversed, false},
    {"reversed_infinite", DepthRange::reversed, true},
}};

enum class DepthFormat { unorm16, unorm24, float32 };
inline constexpr std::array kDepthFormats = {DepthFormat::unorm16, DepthFormat::unorm24,
                                             DepthFormat::float32};
std::string_view format_name(DepthFormat format);

enum class DepthArithmetic { in_float, in_double };

class DepthBuffer {
 public:
  // Pre-condition: 0 < near < far. Far bounds what is looked at even where the far plane is infinite.
  DepthBuffer(const DepthConvention& convention, DepthFormat format, DepthArithmetic arithmetic,
              float near, float far);

  float near() const { return near_; }
  float far() const { return far_; }

  // What is stored for a point that far in front of the eye: a number in [0, 1] of the format.
  double stored(float distance) const;
  // The stored number's place among all numbers of the format, so counted that it grows with distance:
  // of two points the nearer has the smaller code, or the buffer can't tell them in order.
  std::int64_t code(float distance) const;
  // The depth in [0, 1] that belongs to the distance, without any rounding.
  reference::Rational exact(float distance) const;
  // |stored - exact| in units in the last place of the format: of float at the exact value, of a
  // fixed-point format 1 / (2^bits - 1).
  double error_ulp(float distance) const;

 private:
  double window_depth(float distance) const;

  DepthConvention convention_;
  DepthFormat format_;
  DepthArithmetic arithmetic_;
  float near_, far_;
  Projection<float> in_float_;
  Projection<double> in_double_;
  reference::Truth truth_;
};

}  // namespace clipscope::experiments

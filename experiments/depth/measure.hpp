// SPDX-License-Identifier: GPL-3.0-or-later
//
// Depth buffers: what is stored for a point so far in front of the eye, by depth convention and
// format, and how well that tells distances apart. And which numerator makes depth at all.
//
// The way of a point is that of a renderer: the depth row of the projection matrix, the divide,
// from [-1, 1] to [0, 1] where the convention asks for it, clamping, and rounding to the format.
// The input is a float; everything up to the rounding is done in float or in double.
// Sources: Upchurch and Desbrun, "Tightening the Precision of Perspective Rendering", Journal of
// Graphics Tools 16(1), 2012; Reed, "Depth Precision Visualized", 2015; formats: OpenGL 4.6
// specification, 2.3.5. Does not guarantee: the bits of a particular GPU, which may convert to a
// fixed-point format in less than double, and may interpolate depth over a triangle first.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/depth/rows.hpp"
#include "experiments/scenes/random.hpp"
#include "reference/truth.hpp"
#include "spaces/projection.hpp"

namespace clipscope::experiments::depth {

struct Convention {
  std::string_view name;
  DepthRange range;
  bool infinite_far;
};

inline constexpr std::array<Convention, 6> kConventions = {{
    {"gl", DepthRange::minus_one_to_one, false},
    {"gl_infinite", DepthRange::minus_one_to_one, true},
    {"zero_to_one", DepthRange::zero_to_one, false},
    {"zero_to_one_infinite", DepthRange::zero_to_one, true},
    {"reversed", DepthRange::reversed, false},
    {"reversed_infinite", DepthRange::reversed, true},
}};

// What --scalar asks for. Errors: UsageError if neither float nor double is among the scalars.
std::vector<Arithmetic> arithmetics_of(const std::vector<std::string>& scalars);

class Buffer {
 public:
  // Pre-condition: 0 < near < far. Far bounds what is looked at even where the far plane is
  // infinite.
  Buffer(const Convention& convention, Stored format, Arithmetic arithmetic, float near, float far);

  float near() const { return near_; }
  float far() const { return far_; }

  // What is stored for a point that far in front of the eye: a number in [0, 1] of the format.
  double stored(float distance) const;
  // The stored number's place among all numbers of the format, so counted that it grows with
  // distance: of two points the nearer has the smaller code, or the buffer can't tell them in
  // order.
  std::int64_t code(float distance) const;
  // The depth in [0, 1] that belongs to the distance, without any rounding.
  reference::Rational exact(float distance) const;
  // |stored - exact| in units in the last place of the format: of float at the exact value, of a
  // fixed-point format 1 / (2^bits - 1).
  double error_ulp(float distance) const;

 private:
  Convention convention_;
  Stored format_;
  float near_, far_;
  std::function<double(float)> window_depth_;  // at a distance, as the arithmetic computes it
  reference::Truth truth_;
};

// Random distances from near to far, one in each of `count` logarithmically equal pieces, strictly
// ascending; fewer where two fall onto the same float.
std::vector<float> spread_distances(float near, float far, std::size_t count, Random& random);

// An ascending list of distances: how many neighbours does the buffer put in the wrong order, how
// many does it not tell apart, and how many different values does it store?
struct Order {
  std::size_t pairs = 0, misordered = 0, tied = 0, distinct = 0;
};
Order order_of(const Buffer& buffer, std::span<const float> distances);

// The smallest separation in metres at which 64 pairs of points about a distance are all told apart
// in the right order; multiples of the float spacing there are tried, by doubling and then
// bisection. The second point is the nearer one, but at the near plane the farther one. Nothing if
// not even the near plane is told from the distance.
// Does not guarantee: that every larger separation is told apart, too.
std::optional<double> resolution(const Buffer& buffer, float distance);

// z''/w at the distance d = w in front of the eye, with the numerator in use, the linear one, or
// with the quadratic one, which would make it proportional to distance:
//
//   linear     z'' = ((f + n) d - 2 f n) / (f - n)      z''/d is hyperbolic in d
//   quadratic  z'' = (2 d^2 - (f + n) d) / (f - n)      z''/d is linear in d
//
// Both are -1 at d = n and 1 at d = f. What a rasterizer asks of depth is more than order: it
// interpolates z''/w linearly over the screen, so the image of a straight line must be straight.
// Source: Newman and Sproull, "Principles of Interactive Computer Graphics", 1979, chapter 23.
template <class N>
N depth_ndc(Form form, const N& d, const N& n, const N& f) {
  if (form == Form::linear) {
    const N numerator = ((f + n) * d - N(2) * f * n) / (f - n);
    return numerator / d;
  }
  const N numerator = (N(2) * d * d - (f + n) * d) / (f - n);
  return numerator / d;
}

// In exact arithmetic, where not said otherwise:
//   monotone                    a farther float has a larger depth; neighbouring floats
//   monotone, float and double  the same computed in that arithmetic, equal depth allowed
//   lines stay straight         an edge's depth at a point of the screen, interpolated between its
//                               ends, is the depth of the edge's point seen there; deviation: the
//                               difference
//   nearer wins                 of two edges seen at one point of the screen the nearer has the
//                               smaller interpolated depth
// for both forms. Pre-condition: 0 < near < far.
std::vector<FormRow> check_forms(float near, float far, std::size_t samples, Random& random);

// (1, 1, 0) with left = bottom = -1, right = top = 1, near = 1, far = 10: exact, in float, in
// double.
std::vector<EyePlaneRow> point_beside_the_eye();

}  // namespace clipscope::experiments::depth

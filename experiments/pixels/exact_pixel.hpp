// SPDX-License-Identifier: GPL-3.0-or-later
//
// ExactPrimitive: the exact values of one triangle or line at the centre of a pixel, from its
// homogeneous vertices and without clipping.
//
// Triangles: with V_i = (x, y, w) of vertex i and P the pixel's centre, homogeneous in integers,
//
//   E_i = (V_j x V_k) . P,   det = V_0 . (V_1 x V_2),   sum E_i V_i = det P   (Cramer),
//
// so that E_i are the centre's barycentric coordinates in clip space, up to their sum. Hence, with
// P's own w,
//
//   smooth = sum E_i a_i / sum E_i,   noperspective = sum E_i w_i a_i / (det P_w),
//   1/w = sum E_i / (det P_w),        z/w = sum E_i z_i / (det P_w)
//
// whatever the signs of the w_i (Olano and Greer, "Triangle Scan Conversion using 2D Homogeneous
// Coordinates", 1997; OpenGL 4.6 core, equations 14.9 and 14.10, where all w_i > 0). Of a triangle
// with det = 0 there are no values.
//
// Lines: the pixel's centre is projected onto the line in the window (OpenGL 4.6 core, equations
// 14.4 to 14.7); t / w_b and (1 - t) / w_a over a common denominator D are linear in P, too, and
// take the places of E_i and of det P_w.
//
// Guarantee: nothing is rounded before the last division. The E_i are integers over a power of two,
// of 128 bits where their size allows it and of any length elsewhere.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "experiments/drawcalls/draw_call.hpp"

namespace clipscope::experiments {

__extension__ typedef __int128 Int128;

// Something that each vertex has: its value at a pixel is
// offset + scale * sum E_i of_vertices[i] / (sum E_i if is_perspective, otherwise det P_w).
struct Interpolant {
  std::array<double, 3> of_vertices = {};
  bool is_perspective = false;
  double scale = 1, offset = 0;
};

// At one pixel, signs turned so that det > 0: weights[i] is >= 0 for all i exactly if the centre is
// in the closed triangle where it has w > 0. Each is within 2^-52 of its exact value, relatively.
struct PixelWeights {
  std::array<double, 3> weights = {};
  double sum = 0, det = 0;
  double inverse_sum = 0, inverse_det = 0;
};

// |exact - value| <= bound.
struct Enclosed {
  double value = 0, bound = 0;
  double size = 0;  // the same with all terms positive: at least |value|
};

class ExactPrimitive {
 public:
  // Of 2 or 3 vertices. Pre-condition: their positions are finite; the viewport has an area.
  ExactPrimitive(const DrawCall& call, std::span<const std::uint32_t> vertices);

  // The sign of det: 1 if the part with w > 0 turns counter-clockwise in x_ndc, y_ndc, 0 if there
  // is none with an area. Of a line: 1, or 0 if its ends coincide in the window.
  int orientation() const { return orientation_; }

  // Pre-condition of all: orientation() is not 0; of the first two: the pixel is in the target.
  PixelWeights weights(int x, int y) const;
  // So many px from the pixel that `at` is of; rounded.
  PixelWeights weights_beside(const PixelWeights& at, double dx, double dy) const;
  // The sign of sum E_i n_i, turned so that det > 0.
  int sign(int x, int y, const std::array<double, 3>& n) const;
  mpq_class value(const Interpolant& interpolant, int x, int y) const;

 private:
  // a x + b y + c for the pixel in column x and row y.
  template <class Integer>
  struct Plane {
    Integer a = 0, b = 0, c = 0;
  };
  using LongPlanes = std::vector<Plane<mpz_class>>;

  void set_triangle(const DrawCall& call, std::span<const std::uint32_t> vertices);
  void set_line(const DrawCall& call, std::span<const std::uint32_t> vertices);
  void shorten(const DrawCall& call);
  std::array<mpz_class, 3> long_weights(int x, int y) const;

  LongPlanes planes_;
  std::vector<Plane<Int128>> short_planes_;  // none if they don't fit
  mpz_class det_ = 0;                        // det P_w, or D
  int exponent_ = 0;                         // weights are integers times 2^exponent
  int det_exponent_ = 0;
  double det_double_ = 0, unit_ = 1;
  std::array<double, 3> by_x_ = {}, by_y_ = {};  // how weights grow by px
  int orientation_ = 0;
};

// In double. Weights, their sum and det carry 2^-52, inverses, products and sums after them 2^-53,
// so that the error of the quotient is below 16 * 2^-53 sum |E_i n_i| / |denominator|.
inline Enclosed enclosed(const Interpolant& interpolant, const PixelWeights& at) {
  double numerator = 0, size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double term = at.weights[i] * interpolant.of_vertices[i];
    numerator += term;
    size += std::abs(term);
  }
  const double inverse = interpolant.is_perspective ? at.inverse_sum : at.inverse_det;
  const double value = interpolant.offset + interpolant.scale * (numerator * inverse);
  const double positive =
      std::abs(interpolant.offset) + std::abs(interpolant.scale * size * inverse);
  return {value, 0x1p-48 * positive, positive};
}

// Of float, at that value; below the normal range that at its end.
inline double float_ulp(double value) {
  constexpr std::uint64_t kExponent = std::uint64_t{0x7ff} << 52;
  const double magnitude = std::max(std::abs(value), 0x1p-126);
  const double power = std::bit_cast<double>(std::bit_cast<std::uint64_t>(magnitude) & kExponent);
  return power * 0x1p-23;
}

// Whether the exact primitive has the pixel's centre, borders included: triangles only.
bool covers(const DrawCall& call, std::span<const std::uint32_t> vertices,
            const ExactPrimitive& primitive, int x, int y);

}  // namespace clipscope::experiments

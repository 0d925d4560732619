// SPDX-License-Identifier: MIT
//
// View space for exact corners: the rows of a frustum's planes, and NDC as quotients of them.
//
// With the exact numbers of the frustum, L = left row, R = right row and so on (spaces/planes.hpp),
//
//   x_ndc = (L - R) / ((right - left) w)      w = -z for perspective, 1 for parallel projection
//   z_ndc = (alpha N + beta F + gamma) / (scale w), N = near row, F = far row:
//
//                          perspective      infinite far      parallel
//     -1 to 1              far N - near F   N - near          N - F
//     0 to 1               far N            N                 N
//     reversed             near F           near              F
//     scale                far - near       1                 far - near
//
// so that inside, where L, R, N, F >= 0, cancellation costs no precision. All rows are exact: of
// two products of floats in double, of a sum of two floats, or, if sheared, of three terms.
//
// Source: this project; the forms are those of spaces/planes.hpp, their quotients those of the
// matrices in spaces/projection.hpp.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>

#include "spaces/barycentric/exact_corners.hpp"
#include "spaces/barycentric/exact_lines.hpp"
#include "spaces/planes.hpp"
#include "spaces/projection.hpp"

namespace clipscope::barycentric {

inline void set_entry(Line& line, int i, const Expansion<3>& v) {
  const int n = v.size();
  line.rounded[i] = v.largest();
  line.error[i] = n > 1 ? v[n - 2] : 0;
  line.rest[i] = n > 2 ? v[n - 3] : 0;
}

// x + shear z - bound, or that times -1. Compressed, what is beside the largest component is the
// rounding error of a sum that gave it, and less than 2^-50 of that: together less than 2 u.
inline void set_parallel_entry(Line& line, int i, double x, double shear_z, double bound) {
  const auto [sum, error] = bounds::two_sum(x, -bound);
  if (shear_z == 0) {
    line.rounded[i] = sum;
    line.error[i] = error;
    return;
  }
  Expansion<1> product;
  product.push(shear_z);
  set_entry(line, i, compressed<3>(Expansion<2>(sum, error) + product));
}

// The row of one of the six planes. Every product is of two floats. Pre-condition: the frustum has
// the plane, hence a finite far one if that is asked for.
template <int K>
Line view_row(const Frustum<float>& f, Plane plane, const ViewTriangle<float, K>& triangle) {
  Line r{{}, {}, bit(plane), {}};
  const int p = static_cast<int>(plane), axis = p / 2;
  const double sign = p % 2 == 0 ? 1 : -1;
  const std::array<double, 4> bounds = {f.left, f.right, f.bottom, f.top};
  for (int i = 0; i < 3; ++i) {
    const auto& v = triangle[i].position;
    const double z = v[2];
    if (plane == Plane::near) {
      std::tie(r.rounded[i], r.error[i]) = bounds::two_sum(-z, -double{f.near});
    } else if (plane == Plane::far) {
      std::tie(r.rounded[i], r.error[i]) = bounds::two_sum(z, double{f.far});
    } else if (f.kind == ProjectionKind::perspective) {
      std::tie(r.rounded[i], r.error[i]) =
          bounds::two_sum(sign * f.near * v[axis], sign * bounds[p] * z);
    } else {
      const double shear = axis == 0 ? f.shear_x : f.shear_y;
      set_parallel_entry(r, i, sign * v[axis], sign * shear * z, sign * bounds[p]);
    }
  }
  return r;
}

// A coordinate's numerator, alpha a + beta b + gamma, and its values at the vertices in double.
struct RowCombination {
  const Line *a, *b;
  double alpha, beta, gamma;
  Values value{}, magnitude{};

  // At most three roundings: two of a sheared row and the sum, or one of a row, a product and a
  // sum.
  RowCombination(const Line& a_row, double a_factor, const Line& b_row, double b_factor,
                 double constant)
      : a(&a_row), b(&b_row), alpha(a_factor), beta(b_factor), gamma(constant) {
    for (int i = 0; i < 3; ++i) {
      const double from_a = alpha * a->rounded[i], from_b = beta * b->rounded[i];
      value[i] = from_a + from_b + gamma;
      magnitude[i] = std::abs(from_a) + std::abs(from_b) + std::abs(gamma);
    }
  }

  // lambda . numerator.
  ExactDot exact(const ExactLambda& lambda) const {
    ExactDot r;
    if (gamma != 0) r = compressed_dot(exact_dot(lambda, kOnes) * gamma);
    if (alpha != 0) r = compressed_dot(r + exact_dot(lambda, *a) * alpha);
    if (beta != 0) r = compressed_dot(r + exact_dot(lambda, *b) * beta);
    return r;
  }
};

// A difference of floats that is > 0: the denominator of a coordinate, over w.
struct Scale {
  double rounded, error, inverse;

  Scale(float high, float low) {
    std::tie(rounded, error) = bounds::two_sum(double{high}, -double{low});
    inverse = 1 / rounded;
  }
};

inline RowCombination depth_numerator(const Frustum<float>& f, const Line& near, const Line& far) {
  const double n = f.near, z = f.infinite_far ? 0 : f.far;
  if (f.infinite_far) {
    switch (f.depth) {
      case DepthRange::minus_one_to_one: return {near, 1, far, 0, -n};
      case DepthRange::zero_to_one: return {near, 1, far, 0, 0};
      case DepthRange::reversed: return {near, 0, far, 0, n};
    }
  }
  const bool perspective = f.kind == ProjectionKind::perspective;
  const double of_near = perspective ? z : 1, of_far = perspective ? n : 1;
  switch (f.depth) {
    case DepthRange::zero_to_one: return {near, of_near, far, 0, 0};
    case DepthRange::reversed: return {near, 0, far, of_far, 0};
    case DepthRange::minus_one_to_one: break;
  }
  return {near, of_near, far, -of_far, 0};
}

using ViewRows = std::array<Line, kPlanes>;

// The far row of an infinite frustum is 0.
template <int K>
ViewRows view_rows(const Frustum<float>& f, const ViewTriangle<float, K>& triangle) {
  ViewRows r;
  for (const Plane plane : kAllPlanes) {
    if (plane == Plane::far && f.infinite_far) continue;
    r[static_cast<int>(plane)] = view_row(f, plane, triangle);
  }
  return r;
}

// Comparisons with 0 of exact numbers' leading components: exact.
inline Outcode view_outcode(const ViewRows& rows, std::size_t i) {
  Outcode code = 0;
  for (int p = 0; p < kPlanes; ++p) code |= static_cast<Outcode>(rows[p].rounded[i] < 0) << p;
  return code;
}

// The part of a view-space triangle inside the volume; whether it has three corners or more.
// Nothing is left of a triangle with a clip distance that cuts and isn't finite. Pre-condition:
// finite positions.
template <int K, class Count>
bool cut_view_triangle(const ClipVolume& volume, const ViewTriangle<float, K>& triangle,
                       const ViewRows& rows, CutTriangle& cut, Count& count) {
  const OutcodeSummary code =
      summarize_outcodes(volume, triangle, [&](std::size_t i) { return view_outcode(rows, i); });
  if (code.all != 0 || !has_finite_distances(code.any, triangle)) return false;
  const auto is_inside = [&](Plane side, std::size_t i) {
    return rows[static_cast<int>(side)].rounded[i] > 0;
  };
  if (is_beyond_open_side(volume, 3, is_inside)) return false;
  const auto row_of = [&](Plane plane) {
    return is_clip_distance(plane) ? clip_distance_row(plane, triangle)
                                   : rows[static_cast<int>(plane)];
  };
  cut_triangle(code.any, row_of, cut, count);
  return cut.corners.size() >= 3;
}

// The points of a view-space triangle in NDC.
class ViewPoints {
 public:
  template <int K>
  ViewPoints(const Frustum<float>& frustum, const ViewRows& rows,
             const ViewTriangle<float, K>& triangle)
      : frustum_(frustum),
        numerators_{{{rows[0], 1, rows[1], -1, 0},
                     {rows[2], 1, rows[3], -1, 0},
                     depth_numerator(frustum, rows[4], rows[5])}},
        scales_{{{frustum.right, frustum.left},
                 {frustum.top, frustum.bottom},
                 frustum.infinite_far ? Scale(1, 0) : Scale(frustum.far, frustum.near)}} {
    for (int i = 0; i < 3; ++i) w_.rounded[i] = is_perspective() ? -triangle[i].position[2] : 1;
  }

  const Line& w() const { return w_; }

  // x, y, z and 1/w at a meeting with w > 0, rounded; coordinates on their planes exactly.
  template <class Count>
  Vec4<float> position(const Meeting& m, Count& count) const {
    const Divisor w = divisor(m, w_.rounded);
    Vec4<float> r(0);
    const Outcode fixed = set_fixed(frustum_.depth, m, 1, r);
    for (int c = 0; c < 3; ++c) {
      if ((fixed >> c & 1) == 0) r[c] = coordinate(c, m, w, count);
    }
    r[3] = is_perspective() ? rounded_quotient(m, kOnes, w, count) : 1;
    return r;
  }

 private:
  bool is_perspective() const { return frustum_.kind == ProjectionKind::perspective; }

  template <class Count>
  float coordinate(int c, const Meeting& m, const Divisor& w, Count& count) const {
    const RowCombination& numerator = numerators_[c];
    const Scale& scale = scales_[c];
    const auto exact = [&](float, float) {
      const ExactLambda lambda = exact_lambda(m);
      const Expansion<2> exact_scale(scale.rounded, scale.error);
      return round_quotient(numerator.exact(lambda),
                            compressed_dot(exact_dot(lambda, w_.rounded) * exact_scale), count);
    };
    return rounded_quotient(dot(m, numerator.value, numerator.magnitude), w, scale.inverse, exact,
                            count);
  }

  const Frustum<float>& frustum_;
  std::array<RowCombination, 3> numerators_;
  std::array<Scale, 3> scales_;
  Line w_;
};

}  // namespace clipscope::barycentric

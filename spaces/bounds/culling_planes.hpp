// SPDX-License-Identifier: MIT
//
// The planes of a view volume in the form that bounding volumes are held against, with what is
// needed to bound the rounding of every signed distance.
//
// Made from a frustum, a projection, or any matrix to clip space; once per frame, say. Extraction
// from a matrix: Gribb and Hartmann, "Fast Extraction of Viewing Frustum Planes from the
// World-View-Projection Matrix", 2001.
//
// Rounding. A plane's form is d = n . p + offset, and over a volume it takes the values from
// low to high. Let W be the sum of the magnitudes of all products and constants that make d up,
// at their largest over the volume. Then, u being the unit roundoff:
//
//   - n and offset are exact, or (from a matrix) one rounding away from a sum of two given numbers;
//     W is made of the magnitudes of those two, so it bounds what cancelled as well;
//   - a product takes part in at most 7 more roundings (an oriented box: its own, 2 in the dot
//     product, 1 by the half extent, 3 in sums), so low and high are wrong by at most gamma_8 W,
//     where gamma_n = n u / (1 - n u): Higham, "Accuracy and Stability of Numerical Algorithms",
//     2002, lemma 3.1;
//   - a clipper that transforms a point by the matrix rounds each coordinate of the clip position
//     by at most gamma_4 of its terms, in any order of summation and with or without FMA, and both
//     coordinates of w - x (and so on) together by gamma_4 W: 12 in all;
//   - W is itself computed, with at most 9 roundings, so it may be too small by gamma_9 W.
//
// gamma_16 times the computed W covers all of this with room to spare (reference/proofs/). u is
// taken as `epsilon`, the one of directed rounding, so that no rounding mode breaks the bound. Each
// product that underflows adds at most the smallest normal number, even if results are flushed to
// zero; a later factor multiplies that. There are fewer than 32 products: 32 * min * (1 + the
// factors) covers them.
// An overflow makes the bound infinite or NaN, which settles nothing.
// Does not guarantee: anything if subnormal input is taken for zero (DAZ), or if the planes are
// made from subnormal numbers while results are flushed.
#pragma once

#include <glm/mat4x4.hpp>

#include "spaces/bounds/volumes.hpp"
#include "spaces/planes.hpp"

namespace clipscope {

// Inside is normal . p + offset >= 0.
template <std::floating_point T>
struct CullingPlane {
  Vec3<T> normal;
  T offset = T(0);
  // |normal| and |offset| or more: the magnitudes of the terms of which they are sums.
  Vec3<T> weight;
  T offset_weight = T(0);
  // The lengths of normal and weight, rounded up: by them a sphere needs no square root, and both
  // "outside" and "inside" err to the safe side.
  T normal_length = T(0), weight_length = T(0);
};

template <std::floating_point T>
struct CullingPlanes {
  // In the order of enum Plane; an infinite far plane of a frustum is left out.
  std::array<CullingPlane<T>, kPlanes> planes;
  int count = 0;
  // A box that contains the whole volume; unbounded if it is not known, as from a matrix alone
  // (with_reach in culling_hull.hpp).
  AxisBox<T> reach = {Vec3<T>(-std::numeric_limits<T>::infinity()),
                      Vec3<T>(std::numeric_limits<T>::infinity())};
};

// As above: n of gamma_n, and the number of products that may underflow.
inline constexpr int kDistanceRoundings = 16, kMostProducts = 32;
// Of a length as below, and of a normal that is a rounded sum.
inline constexpr int kLengthRoundings = 8, kNormalRoundings = 2;

// The error bound of a signed distance whose terms' magnitudes sum up to `magnitude`, where
// products that may underflow are multiplied by at most 1 + factor afterwards.
template <std::floating_point T>
constexpr T distance_error(const T& magnitude, const T& factor = T(0)) {
  constexpr T u = std::numeric_limits<T>::epsilon();
  constexpr T gamma = kDistanceRoundings * u / (1 - kDistanceRoundings * u);
  constexpr T underflow = kMostProducts * std::numeric_limits<T>::min();
  return gamma * magnitude + underflow * (T(1) + factor);
}

// The length of a vector or more: at most 10 u too large, plus the smallest normal number.
// The quotients are at most 1 and one of them is 1, so that no square overflows or matters if it
// underflows; each of up to six roundings is covered.
template <std::floating_point T>
T length_above(const Vec3<T>& v) {
  const T x = std::abs(v[0]), y = std::abs(v[1]), z = std::abs(v[2]);
  const T most = std::max({x, y, z});
  if (!(T(0) < most)) {
    return most;  // 0 or NaN
  }
  const T a = x / most, b = y / most, c = z / most;
  constexpr T up = T(1) + kLengthRoundings * std::numeric_limits<T>::epsilon();
  return most * std::sqrt(a * a + b * b + c * c) * up + std::numeric_limits<T>::min();
}

namespace bounds {

template <std::floating_point T>
void push_back(CullingPlanes<T>& r, CullingPlane<T> plane) {
  plane.normal_length = length_above(plane.normal);
  plane.weight_length = length_above(plane.weight);
  // A normal from a matrix is a rounded sum: the true one is longer by at most one rounding.
  plane.normal_length += kNormalRoundings * std::numeric_limits<T>::epsilon() * plane.normal_length;
  r.planes[static_cast<std::size_t>(r.count++)] = plane;
}

// A plane whose numbers are exact.
template <std::floating_point T>
void push_back(CullingPlanes<T>& r, const Vec3<T>& normal, const T& offset) {
  push_back(r, {normal, offset, absolute(normal), std::abs(offset)});
}

// The plane a + sign * b >= 0 of two rows of a matrix.
template <std::floating_point T>
void push_back(CullingPlanes<T>& r, const Vec4<T>& a, int sign, const Vec4<T>& b) {
  Vec4<T> sum, weight;
  for (int i = 0; i < 4; ++i) {
    sum[i] = sign < 0 ? a[i] - b[i] : a[i] + b[i];
    weight[i] = std::abs(a[i]) + std::abs(b[i]);
  }
  push_back(r, {Vec3<T>(sum[0], sum[1], sum[2]), sum[3], Vec3<T>(weight[0], weight[1], weight[2]),
                weight[3]});
}

// [low, high], moved outwards by more than `roundings` roundings of terms as large as `magnitude`.
template <std::floating_point T>
void set_reach(AxisBox<T>& reach, int axis, const T& low, const T& high, const T& magnitude) {
  const T error = distance_error(magnitude);
  reach.lower[axis] = low - error;
  reach.upper[axis] = high + error;
}

// x of a perspective frustum is widest at the near or at the far plane: bounds there are
// left and left * far / near.
template <std::floating_point T>
void set_perspective_reach(AxisBox<T>& reach, const Frustum<T>& f, int axis, T low, T high) {
  const T infinity = std::numeric_limits<T>::infinity();
  const T ratio = f.infinite_far ? infinity : f.far / f.near;
  const T low_far = low < T(0) ? low * ratio : low, high_far = high > T(0) ? high * ratio : high;
  if (std::isfinite(low_far) && std::isfinite(high_far)) {
    set_reach(reach, axis, low_far, high_far, std::max(std::abs(low_far), std::abs(high_far)));
    return;
  }
  reach.lower[axis] = low < T(0) ? -infinity : low;
  reach.upper[axis] = high > T(0) ? infinity : high;
}

// x = X - shear z with low <= X <= high and -far <= z <= -near.
template <std::floating_point T>
void set_parallel_reach(AxisBox<T>& reach, const Frustum<T>& f, int axis, T low, T high, T shear) {
  const T a = shear * f.near, b = shear * f.far;
  const T magnitude = std::abs(low) + std::abs(high) + std::abs(a) + std::abs(b);
  if (std::isfinite(magnitude)) {
    set_reach(reach, axis, low + std::min(a, b), high + std::max(a, b), magnitude);
  }
}

}  // namespace bounds

// The planes of a frustum in view space: those of view_distance, exactly.
// Pre-condition: is_valid(f).
template <std::floating_point T>
CullingPlanes<T> culling_planes(const Frustum<T>& f) {
  const T o(0), i(1);
  CullingPlanes<T> r;
  r.reach.upper[2] = -f.near;
  if (!f.infinite_far) r.reach.lower[2] = -f.far;
  if (f.kind == ProjectionKind::perspective) {
    bounds::push_back(r, Vec3<T>(f.near, o, f.left), o);
    bounds::push_back(r, Vec3<T>(-f.near, o, -f.right), o);
    bounds::push_back(r, Vec3<T>(o, f.near, f.bottom), o);
    bounds::push_back(r, Vec3<T>(o, -f.near, -f.top), o);
    bounds::set_perspective_reach(r.reach, f, 0, f.left, f.right);
    bounds::set_perspective_reach(r.reach, f, 1, f.bottom, f.top);
  } else {
    bounds::push_back(r, Vec3<T>(i, o, f.shear_x), -f.left);
    bounds::push_back(r, Vec3<T>(-i, o, -f.shear_x), f.right);
    bounds::push_back(r, Vec3<T>(o, i, f.shear_y), -f.bottom);
    bounds::push_back(r, Vec3<T>(o, -i, -f.shear_y), f.top);
    bounds::set_parallel_reach(r.reach, f, 0, f.left, f.right, f.shear_x);
    bounds::set_parallel_reach(r.reach, f, 1, f.bottom, f.top, f.shear_y);
  }
  bounds::push_back(r, Vec3<T>(o, o, -i), -f.near);
  if (!f.infinite_far) bounds::push_back(r, Vec3<T>(o, o, i), f.far);
  return r;
}

// The six planes that a matrix to clip space gives: row i yields clip coordinate i.
template <std::floating_point T>
CullingPlanes<T> culling_planes(DepthRange depth, const MatrixRows<T>& rows) {
  const Vec4<T>&x = rows[0], &y = rows[1], &z = rows[2], &w = rows[3];
  CullingPlanes<T> r;
  bounds::push_back(r, w, 1, x);
  bounds::push_back(r, w, -1, x);
  bounds::push_back(r, w, 1, y);
  bounds::push_back(r, w, -1, y);
  const Vec4<T> low_w = depth == DepthRange::minus_one_to_one ? w : Vec4<T>(T(0));
  if (depth == DepthRange::reversed) {
    bounds::push_back(r, w, -1, z);
    bounds::push_back(r, low_w, 1, z);
  } else {
    bounds::push_back(r, low_w, 1, z);
    bounds::push_back(r, w, -1, z);
  }
  return r;
}

// The rows of a matrix. GLM's matrices are given by columns.
template <std::floating_point T>
MatrixRows<T> rows_of(const glm::mat<4, 4, T, glm::defaultp>& m) {
  MatrixRows<T> rows;
  for (int i = 0; i < 4; ++i) {
    rows[static_cast<std::size_t>(i)] = Vec4<T>(m[0][i], m[1][i], m[2][i], m[3][i]);
  }
  return rows;
}

template <std::floating_point T>
CullingPlanes<T> culling_planes(DepthRange depth, const glm::mat<4, 4, T, glm::defaultp>& m) {
  return culling_planes(depth, rows_of(m));
}

// The planes that the rounded matrix of a projection gives, in view space.
template <std::floating_point T>
CullingPlanes<T> culling_planes(const Projection<T>& p) {
  return culling_planes(p.frustum.depth, rows_of(p));
}

}  // namespace clipscope

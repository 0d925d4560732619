// SPDX-License-Identifier: MIT
//
// Bounding volumes of points: each contains every point given, rounding included.
//
// Box: the least and greatest coordinates; exact.
// Sphere: centre by Ritter, "An Efficient Bounding Sphere", Graphics Gems, 1990, or the middle of
// the
//   box if that makes it smaller. Any centre serves: the radius is the largest distance from the
//   centre as rounded, rounded up.
// Oriented box: along given axes, or along the principal axes of the points' covariance.
//
// Guarantees: in every rounding mode, the exact volume contains every point. A point with a NaN or
// infinite coordinate, and any overflow, makes the volume one with an infinite size, for which
// visibility() answers look_closer. No point makes the empty volume. No allocation.
// Does not guarantee: the smallest sphere or oriented box.
#pragma once

#include <span>

#include "spaces/bounds/culling_planes.hpp"

namespace clipscope {

template <std::floating_point T>
AxisBox<T> bounding_box(std::span<const Vec3<T>> points) {
  AxisBox<T> r;
  for (const Vec3<T>& p : points) {
    if (!is_finite(p)) {
      return {Vec3<T>(-std::numeric_limits<T>::infinity()),
              Vec3<T>(std::numeric_limits<T>::infinity())};
    }
    r = enclose(r, AxisBox<T>{p, p});
  }
  return r;
}

namespace bounds {

// The largest distance of a point from the centre, or more. Differences are scaled by a power of
// two, so that no square overflows and those that underflow are far from the largest one.
// Roundings: 1 of the difference, 1 of the square and 2 of sums, halved by the root; 1 of the root.
template <std::floating_point T>
T distance_above(std::span<const Vec3<T>> points, const Vec3<T>& centre) {
  T most(0);
  for (const Vec3<T>& p : points) {
    for (int i = 0; i < 3; ++i) most = std::max(most, std::abs(p[i] - centre[i]));
  }
  if (!(T(0) < most) || !std::isfinite(most)) return most;
  const int exponent = std::ilogb(most);
  T square(0);
  for (const Vec3<T>& p : points) {
    T sum(0);
    for (int i = 0; i < 3; ++i) {
      const T d = std::scalbn(p[i] - centre[i], -exponent);
      sum += d * d;
    }
    square = std::max(square, sum);
  }
  constexpr T up = T(1) + kLengthRoundings * std::numeric_limits<T>::epsilon();
  return std::scalbn(std::sqrt(square) * up, exponent) + std::numeric_limits<T>::min();
}

template <std::floating_point T>
constexpr T distance_squared(const Vec3<T>& a, const Vec3<T>& b) {
  const T x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  return x * x + y * y + z * z;
}

template <std::floating_point T>
const Vec3<T>& farthest(std::span<const Vec3<T>> points, const Vec3<T>& from) {
  const Vec3<T>* r = &points[0];
  for (const Vec3<T>& p : points) {
    r = distance_squared(*r, from) < distance_squared(p, from) ? &p : r;
  }
  return *r;
}

// Ritter's sphere around two points far apart, grown by every point that is outside.
template <std::floating_point T>
Vec3<T> ritter_centre(std::span<const Vec3<T>> points) {
  const Vec3<T>& a = farthest(points, points[0]);
  const Vec3<T>& b = farthest(points, a);
  Vec3<T> centre = T(0.5) * a + T(0.5) * b;
  T radius = T(0.5) * std::sqrt(distance_squared(a, b));
  for (const Vec3<T>& p : points) {
    const T distance = std::sqrt(distance_squared(p, centre));
    if (distance > radius) {
      const T shift = T(0.5) - T(0.5) * (radius / distance);
      centre += shift * (p - centre);
      radius = T(0.5) * radius + T(0.5) * distance;
    }
  }
  return is_finite(centre) ? centre : T(0.5) * a + T(0.5) * b;
}

// v with length 1, or `otherwise` if that can't be formed.
template <std::floating_point T>
Vec3<T> unit(const Vec3<T>& v, const Vec3<T>& otherwise) {
  const T length = length_above(v);
  const Vec3<T> r = v / length;
  const T square = dot(r, r);
  return T(0.5) < square && square < T(2) ? r : otherwise;
}

// The axes of an oriented box may be so far from perpendicular and of length 1; half its size is
// enlarged by so many roundings.
inline constexpr double kMostSkew = 0.0625;
inline constexpr int kHalfSizeRoundings = 4;

// How far the axes are from perpendicular and of length 1: the largest sum of magnitudes in a row
// of A^T A - I, or more. NaN if an axis isn't finite.
template <std::floating_point T>
T skew(const std::array<Vec3<T>, 3>& axes) {
  T most(0);
  for (std::size_t i = 0; i < 3; ++i) {
    T sum(0), magnitude(1);
    for (std::size_t k = 0; k < 3; ++k) {
      sum += std::abs(dot(axes[i], axes[k]) - (i == k ? T(1) : T(0)));
      magnitude += dot(Vec3<T>(std::abs(axes[i][0]), std::abs(axes[i][1]), std::abs(axes[i][2])),
                       Vec3<T>(std::abs(axes[k][0]), std::abs(axes[k][1]), std::abs(axes[k][2])));
    }
    most = std::max(most, sum + distance_error(magnitude));
    if (!std::isfinite(sum)) return std::numeric_limits<T>::quiet_NaN();
  }
  return most;
}

// The axis along which the points spread most: the power method on their covariance, from the
// longest side of their box. Any result will do; a better one makes a smaller box.
template <std::floating_point T>
std::array<Vec3<T>, 3> principal_axes(std::span<const Vec3<T>> points, const AxisBox<T>& box) {
  const Vec3<T> x(T(1), T(0), T(0)), y(T(0), T(1), T(0)), z(T(0), T(0), T(1));
  const Vec3<T> size = T(0.5) * box.upper - T(0.5) * box.lower;
  const Vec3<T> middle = T(0.5) * box.upper + T(0.5) * box.lower;
  const T most = std::max({size[0], size[1], size[2]});
  if (!(T(0) < most)) return {x, y, z};
  const T weight = T(1) / static_cast<T>(points.size());
  Vec3<T> mean(T(0));
  for (const Vec3<T>& p : points) mean += weight * ((p - middle) / most);
  std::array<Vec3<T>, 3> covariance = {Vec3<T>(T(0)), Vec3<T>(T(0)), Vec3<T>(T(0))};
  for (const Vec3<T>& p : points) {
    const Vec3<T> d = (p - middle) / most - mean;
    for (int i = 0; i < 3; ++i) covariance[static_cast<std::size_t>(i)] += weight * d[i] * d;
  }
  const auto spread = [&](const Vec3<T>& v) {
    return Vec3<T>(dot(covariance[0], v), dot(covariance[1], v), dot(covariance[2], v));
  };
  constexpr int kSteps = 32;
  Vec3<T> first = unit(size, x);
  for (int i = 0; i < kSteps; ++i) first = unit(spread(first), first);
  const Vec3<T> aside = std::abs(first[0]) < T(0.5) ? x : y;
  Vec3<T> second = unit(cross(first, aside), z);
  for (int i = 0; i < kSteps; ++i) {
    const Vec3<T> s = spread(second);
    second = unit(Vec3<T>(s - dot(first, s) * first), second);
  }
  return {first, second, unit(cross(first, second), z)};
}

}  // namespace bounds

template <std::floating_point T>
Sphere<T> bounding_sphere(std::span<const Vec3<T>> points) {
  if (points.empty()) return {};
  const AxisBox<T> box = bounding_box(points);
  if (!is_finite(box)) return {Vec3<T>(T(0)), std::numeric_limits<T>::infinity()};
  const auto around = [&](const Vec3<T>& centre) {
    return Sphere<T>{centre, bounds::distance_above(points, centre)};
  };
  const Sphere<T> ritter = around(bounds::ritter_centre(points));
  const Sphere<T> middle = around(T(0.5) * box.lower + T(0.5) * box.upper);
  return middle.radius < ritter.radius ? middle : ritter;
}

// The box along the given axes, which should be of length 1 and perpendicular to each other; if
// they are far from it the box is along x, y and z.
//
// A point is centre + sum of t_i axes_i with A^T (p - centre) = A^T A t = (I + E) t, where A has
// the axes as columns and e bounds the sums of magnitudes in the rows of E. So |t| <= |A^T (p -
// centre)| / (1 - e) in the largest component, and t_i differs from the dot product with axis i by
// at most e |t|. The dot products round by at most gamma_4 of their terms; distance_error covers
// that.
template <std::floating_point T>
OrientedBox<T> bounding_oriented_box(std::span<const Vec3<T>> points,
                                     const std::array<Vec3<T>, 3>& axes) {
  OrientedBox<T> r;
  if (points.empty()) return r;
  const T e = bounds::skew(axes);
  if (e <= T(bounds::kMostSkew)) r.axes = axes;
  const bool along_axes = !(e <= T(bounds::kMostSkew));
  const AxisBox<T> box = bounding_box(points);
  r.centre = T(0.5) * box.lower + T(0.5) * box.upper;
  Vec3<T> reach(T(0));
  T most(0), magnitude(0);
  for (const Vec3<T>& p : points) {
    const Vec3<T> d = p - r.centre;
    for (int i = 0; i < 3; ++i) {
      const Vec3<T>& axis = r.axes[static_cast<std::size_t>(i)];
      reach[i] = std::max(reach[i], std::abs(bounds::dot(axis, d)));
    }
    magnitude = std::max(magnitude, std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]));
  }
  // An axis near length 1 has no component above 2.
  const T error = distance_error(T(2) * magnitude, magnitude);
  for (int i = 0; i < 3; ++i) most = std::max(most, reach[i] + error);
  const T tilt = along_axes ? T(0) : T(2) * e * most;
  for (int i = 0; i < 3; ++i) {
    r.half[i] = (reach[i] + error + tilt) *
                (T(1) + bounds::kHalfSizeRoundings * std::numeric_limits<T>::epsilon());
  }
  if (!is_finite(box) || !is_finite(r)) {
    r.centre = Vec3<T>(T(0));
    r.half = Vec3<T>(std::numeric_limits<T>::infinity());
  }
  return r;
}

// The box along the principal axes of the points.
template <std::floating_point T>
OrientedBox<T> bounding_oriented_box(std::span<const Vec3<T>> points) {
  const AxisBox<T> box = bounding_box(points);
  if (points.empty() || !is_finite(box)) {
    return bounding_oriented_box(points, OrientedBox<T>{}.axes);
  }
  return bounding_oriented_box(points, bounds::principal_axes(points, box));
}

}  // namespace clipscope

// SPDX-License-Identifier: MIT
//
// Bounding volumes: axis-aligned box, sphere and oriented box.
//
// Each is a closed set of points, given exactly by its numbers. The space they live in is the
// user's business: view space for a frustum, any space for a matrix that leads from it to clip
// space. Default-constructed volumes are empty. Scalars are IEEE formats (float, double).
// Does not guarantee: anything about volumes with a NaN or an infinity beyond what each query says.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>

#include "spaces/vertex.hpp"

namespace clipscope {

// lower <= p <= upper in each coordinate. Empty if lower > upper in any.
template <std::floating_point T>
struct AxisBox {
  Vec3<T> lower = Vec3<T>(std::numeric_limits<T>::max());
  Vec3<T> upper = Vec3<T>(std::numeric_limits<T>::lowest());
};

// |p - centre| <= radius. Empty if radius < 0.
template <std::floating_point T>
struct Sphere {
  Vec3<T> centre = Vec3<T>(T(0));
  T radius = T(-1);
};

// centre + sum of t_i axes_i with |t_i| <= half_i. The axes need be neither of length 1 nor
// perpendicular, so the numbers describe the volume exactly whatever rounding did to them.
// Empty if any half_i < 0.
template <std::floating_point T>
struct OrientedBox {
  Vec3<T> centre = Vec3<T>(T(0));
  std::array<Vec3<T>, 3> axes = {Vec3<T>(T(1), T(0), T(0)), Vec3<T>(T(0), T(1), T(0)),
                                 Vec3<T>(T(0), T(0), T(1))};
  Vec3<T> half = Vec3<T>(T(-1));
};

template <std::floating_point T>
bool is_finite(const Vec3<T>& v) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}
template <std::floating_point T>
bool is_finite(const AxisBox<T>& box) {
  return is_finite(box.lower) && is_finite(box.upper);
}
template <std::floating_point T>
bool is_finite(const Sphere<T>& sphere) {
  return is_finite(sphere.centre) && std::isfinite(sphere.radius);
}
template <std::floating_point T>
bool is_finite(const OrientedBox<T>& box) {
  return is_finite(box.centre) && is_finite(box.axes[0]) && is_finite(box.axes[1]) &&
         is_finite(box.axes[2]) && is_finite(box.half);
}

template <std::floating_point T>
constexpr bool is_empty(const AxisBox<T>& box) {
  return box.lower[0] > box.upper[0] || box.lower[1] > box.upper[1] || box.lower[2] > box.upper[2];
}
template <std::floating_point T>
constexpr bool is_empty(const Sphere<T>& sphere) {
  return sphere.radius < T(0);
}
template <std::floating_point T>
constexpr bool is_empty(const OrientedBox<T>& box) {
  return box.half[0] < T(0) || box.half[1] < T(0) || box.half[2] < T(0);
}

// The smallest box around two boxes; exact. Pre-condition: no NaN.
template <std::floating_point T>
constexpr AxisBox<T> enclose(const AxisBox<T>& a, const AxisBox<T>& b) {
  AxisBox<T> r;
  for (int i = 0; i < 3; ++i) {
    r.lower[i] = std::min(a.lower[i], b.lower[i]);
    r.upper[i] = std::max(a.upper[i], b.upper[i]);
  }
  return r;
}

namespace bounds {

template <std::floating_point T>
constexpr T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <std::floating_point T>
constexpr Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return Vec3<T>(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
}

template <std::floating_point T>
Vec3<T> absolute(const Vec3<T>& v) {
  return Vec3<T>(std::abs(v[0]), std::abs(v[1]), std::abs(v[2]));
}

}  // namespace bounds

}  // namespace clipscope

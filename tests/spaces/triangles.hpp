// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles for tests: literal ones, and random ones over magnitudes and around the volume.
#pragma once

#include <algorithm>
#include <array>
#include <random>
#include <span>

#include "experiments/contestants/scalars.hpp"
#include "experiments/judge/cycle.hpp"
#include "spaces/clippers.hpp"
#include "tests/catch.hpp"

namespace clipscope::tests {

// Attributes are the barycentric coordinates: 1 at their own vertex, 0 at the others.
inline constexpr int K = 3;

using Corners = std::array<std::array<double, 4>, 3>;

template <Scalar T>
ClipTriangle<T, K> clip_triangle(const Corners& corners) {
  using experiments::scalar_from;
  ClipTriangle<T, K> triangle;
  for (std::size_t i = 0; i < 3; ++i) {
    for (int c = 0; c < 4; ++c) {
      triangle[i].position[c] = scalar_from<T>(corners[i][static_cast<std::size_t>(c)]);
    }
    for (int k = 0; k < K; ++k) triangle[i].attributes[k] = T(static_cast<int>(i) == k ? 1 : 0);
  }
  return triangle;
}

template <Scalar T>
ViewTriangle<T, K> view_triangle(const Corners& corners) {
  const ClipTriangle<T, K> clip = clip_triangle<T>(corners);
  ViewTriangle<T, K> triangle;
  for (std::size_t i = 0; i < 3; ++i) {
    triangle[i].position = Vec3<T>(clip[i].position[0], clip[i].position[1], clip[i].position[2]);
    triangle[i].attributes = clip[i].attributes;
  }
  return triangle;
}

// Small multiples of 1/4 in [-3, 3]: many vertices lie on planes, at w = 0 or at the origin.
inline Corners lattice_corners(std::mt19937_64& random) {
  Corners corners;
  for (auto& corner : corners) {
    for (double& x : corner) x = (static_cast<double>(random() % 25) - 12) / 4;
  }
  return corners;
}

// Floats in [-size, size].
inline Corners random_corners(std::mt19937_64& random, double size) {
  Corners corners;
  for (auto& corner : corners) {
    for (double& x : corner) {
      x = static_cast<float>((static_cast<double>(random() >> 11) * 0x1p-52 - 1) * size);
    }
  }
  return corners;
}

// What a clipper that a test names makes of a triangle.
template <class C, class T>
NdcPolygon<T, K> clip(const ClipTriangle<T, K>& triangle, const ClipVolume& volume = {}) {
  NdcPolygon<T, K> out;
  C{}(volume, triangle, out);
  return out;
}

// Equal, a NaN also to another.
template <class T>
bool same(const T& a, const T& b) {
  return a == b || (!(a == a) && !(b == b));
}

template <class T>
bool same(const NdcVertex<T, K>& a, const NdcVertex<T, K>& b) {
  for (int i = 0; i < 4; ++i) {
    if (!same(a.position[i], b.position[i])) return false;
  }
  for (int k = 0; k < K; ++k) {
    if (!same(a.attributes[k], b.attributes[k])) return false;
  }
  return true;
}

template <Scalar T>
std::span<const NdcVertex<T, K>> vertices(const NdcPolygon<T, K>& polygon) {
  return {polygon.begin(), polygon.end()};
}

// Whether b is a, with the same first vertex.
template <Scalar T>
bool same_polygon(std::span<const NdcVertex<T, K>> a, std::span<const NdcVertex<T, K>> b) {
  return std::ranges::equal(a, b, [](const auto& v, const auto& w) { return same(v, w); });
}
template <Scalar T>
bool same_polygon(const NdcPolygon<T, K>& a, const NdcPolygon<T, K>& b) {
  return same_polygon<T>(vertices(a), vertices(b));
}

// Whether b is a, whichever vertex is first.
template <Scalar T>
bool same_cycle(std::span<const NdcVertex<T, K>> a, std::span<const NdcVertex<T, K>> b) {
  return experiments::same_cycle(a, b, [](const auto& v, const auto& w) { return same(v, w); });
}
template <Scalar T>
bool same_cycle(const NdcPolygon<T, K>& a, const NdcPolygon<T, K>& b) {
  return same_cycle<T>(vertices(a), vertices(b));
}

}  // namespace clipscope::tests

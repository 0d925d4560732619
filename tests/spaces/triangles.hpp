// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles for tests: literal ones, and random ones over magnitudes and around the volume.
#pragma once

#include <array>
#include <random>
#include <string>
#include <vector>

#include "experiments/contestants/scalars.hpp"
#include "spaces/clippers.hpp"

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

// The clippers that keep the contract for every view-space triangle.
using FullClippers =
    TypeList<Textbook, ViewSutherlandHodgman, HomogeneousSutherlandHodgman, CvvNearFirst>;

// The clippers that keep it for every clip-space triangle.
using FullHomogeneousClippers = TypeList<Textbook, HomogeneousSutherlandHodgman>;

}  // namespace clipscope::tests

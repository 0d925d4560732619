// SPDX-License-Identifier: MIT
//
// Vertices, points, segments and triangles, typed by the space they live in.
//
//   view   (x, y, z)        right-handed, the eye at the origin, looking down -z
//   clip   (x, y, z, w)     after the projection, before the divide; w = -z_view for perspective
//   ndc    (x, y, z, 1/w)   after the divide; x and y in [-1, 1] inside the canonical view volume
//
// A vertex carries K attributes: a number fixed at compile time, or kRunTime for a number known
// only at run time (at most kMaxAttributes). In every space the attributes are the true values at
// that point, never divided by w.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <type_traits>

#include "spaces/scalar.hpp"

namespace clipscope {

template <Scalar T>
using Vec3 = glm::vec<3, T, glm::defaultp>;

template <Scalar T>
using Vec4 = glm::vec<4, T, glm::defaultp>;

enum class Space { view, clip, ndc };

inline constexpr int kRunTime = -1;
inline constexpr int kMaxAttributes = 32;

// K attribute values.
template <Scalar T, int K>
struct Attributes {
  static_assert(K >= 0 && K <= kMaxAttributes);
  std::array<T, K> values;

  static constexpr int size() { return K; }
  constexpr void resize(int) {}
  constexpr T& operator[](int k) { return values[k]; }
  constexpr const T& operator[](int k) const { return values[k]; }
};

// A number of attribute values known at run time; no allocation.
template <Scalar T>
struct Attributes<T, kRunTime> {
  std::array<T, kMaxAttributes> values;
  int count = 0;

  constexpr int size() const { return count; }
  // Pre-condition: 0 <= n <= kMaxAttributes. New values are unspecified.
  constexpr void resize(int n) { count = n; }
  constexpr T& operator[](int k) { return values[k]; }
  constexpr const T& operator[](int k) const { return values[k]; }
};

template <Space S, Scalar T>
using Position = std::conditional_t<S == Space::view, Vec3<T>, Vec4<T>>;

template <Space S, Scalar T, int K>
struct Vertex {
  Position<S, T> position;
  Attributes<T, K> attributes;

  static constexpr int kDimension = S == Space::view ? 3 : 4;
};

// Whether no coordinate is NaN or infinite. Attributes are not looked at.
template <Space S, Scalar T, int K>
constexpr bool has_finite_position(const Vertex<S, T, K>& v) {
  for (int i = 0; i < Vertex<S, T, K>::kDimension; ++i) {
    if (!is_finite(v.position[i])) return false;
  }
  return true;
}

template <Scalar T, int K>
using ViewVertex = Vertex<Space::view, T, K>;
template <Scalar T, int K>
using ClipVertex = Vertex<Space::clip, T, K>;
template <Scalar T, int K>
using NdcVertex = Vertex<Space::ndc, T, K>;

// A point, a segment or a triangle: the simplices of 1, 2 and 3 vertices.
template <Space S, Scalar T, int K, std::size_t N>
using Simplex = std::array<Vertex<S, T, K>, N>;

template <Scalar T, int K>
using ViewPoint = Simplex<Space::view, T, K, 1>;
template <Scalar T, int K>
using ClipPoint = Simplex<Space::clip, T, K, 1>;
template <Scalar T, int K>
using ViewSegment = Simplex<Space::view, T, K, 2>;
template <Scalar T, int K>
using ClipSegment = Simplex<Space::clip, T, K, 2>;

template <Space S, Scalar T, int K, std::size_t N>
constexpr bool has_finite_positions(const Simplex<S, T, K, N>& primitive) {
  for (const Vertex<S, T, K>& v : primitive) {
    if (!has_finite_position(v)) return false;
  }
  return true;
}

template <Space S, Scalar T, int K>
using Triangle = Simplex<S, T, K, 3>;
template <Scalar T, int K>
using ViewTriangle = Triangle<Space::view, T, K>;
template <Scalar T, int K>
using ClipTriangle = Triangle<Space::clip, T, K>;

// Makes r the point a + t (b - a) of the edge a-b, attributes included; t = 0 gives a exactly.
template <Space S, Scalar T, int K>
constexpr void interpolate_into(Vertex<S, T, K>& r, const Vertex<S, T, K>& a,
                                const Vertex<S, T, K>& b, const T& t) {
  for (int i = 0; i < Vertex<S, T, K>::kDimension; ++i) {
    r.position[i] = a.position[i] + t * (b.position[i] - a.position[i]);
  }
  r.attributes.resize(a.attributes.size());
  for (int k = 0; k < a.attributes.size(); ++k) {
    r.attributes[k] = a.attributes[k] + t * (b.attributes[k] - a.attributes[k]);
  }
}

template <Space S, Scalar T, int K>
constexpr Vertex<S, T, K> interpolate(const Vertex<S, T, K>& a, const Vertex<S, T, K>& b,
                                      const T& t) {
  Vertex<S, T, K> r;
  interpolate_into(r, a, b, t);
  return r;
}

}  // namespace clipscope

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles for tests: literal ones, and random ones over magnitudes and around the volume.
#pragma once

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

#include "experiments/contestants/scalars.hpp"
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

template <class... Lists>
struct Concatenation;
template <class... As>
struct Concatenation<TypeList<As...>> {
  using type = TypeList<As...>;
};
template <class... As, class... Bs, class... Rest>
struct Concatenation<TypeList<As...>, TypeList<Bs...>, Rest...>
    : Concatenation<TypeList<As..., Bs...>, Rest...> {};

template <class C>
inline constexpr bool kKeepsContract =
    C::promise.covers&& C::promise.contained&& C::promise.attributes&& C::promise.domain !=
    Promise::Domain::in_front;
template <class C>
inline constexpr bool kKeepsClipContract =
    kKeepsContract<C>&& ClipsClipSpace<C, float, K>&& C::promise.domain == Promise::Domain::any;

template <class List>
struct Kept;
template <class... Cs>
struct Kept<TypeList<Cs...>> {
  using View = typename Concatenation<
      TypeList<>, std::conditional_t<kKeepsContract<Cs>, TypeList<Cs>, TypeList<>>...>::type;
  using Clip = typename Concatenation<
      TypeList<>, std::conditional_t<kKeepsClipContract<Cs>, TypeList<Cs>, TypeList<>>...>::type;
};

// The clippers that by their promise keep the contract for every view-space triangle.
using FullClippers = Kept<AllClippers>::View;

// The clippers that keep it for every clip-space triangle.
using FullHomogeneousClippers = Kept<AllClippers>::Clip;

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

// Whether b is a, beginning elsewhere.
template <class T>
bool same_up_to_rotation(const NdcPolygon<T, K>& a, const NdcPolygon<T, K>& b) {
  const int n = a.size();
  if (n != b.size()) return false;
  for (int shift = 0; shift < std::max(n, 1); ++shift) {
    bool equal = true;
    for (int i = 0; i < n && equal; ++i) equal = same(a[i], b[(i + shift) % n]);
    if (equal) return true;
  }
  return false;
}

// Runs f.operator()<C>() for every clipper that there is in T.
template <class T, class Clippers, class F>
void for_each_in(Clippers, F&& f) {
  experiments::for_each_type(Clippers{}, [&]<class C>() {
    if constexpr (ClipsViewSpace<C, T, K>) f.template operator()<C>();
  });
}

// Runs f.operator()<C, T>() for every pair that there is.
template <class Clippers, class F>
void for_every(F&& f) {
  experiments::for_each_type(Clippers{}, [&]<class C>() {
    experiments::for_each_type(experiments::AllScalars{}, [&]<class T>() {
      if constexpr (ClipsViewSpace<C, T, K>) {
        INFO(C::name << " in " << experiments::ScalarTraits<T>::name);
        f.template operator()<C, T>();
      }
    });
  });
}

}  // namespace clipscope::tests

// SPDX-License-Identifier: MIT
//
// Rectangles on the screen, in NDC or px, and the corners of what is projected onto it.
//
// Source: the viewport transform of the OpenGL 4.6 specification, section 13.8.1.
// Guarantees: to_px outward contains the exact rectangle (round-to-nearest, gradual underflow).
// Does not guarantee: anything about the rounding of `corners`, which is that of a matrix product
// in T.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include "spaces/bounds/enclosure_arithmetic.hpp"
#include "spaces/bounds/volumes.hpp"

namespace clipscope {

// left <= x <= right, bottom <= y <= top: closed. Default-constructed it is empty.
template <std::floating_point T>
struct ScreenRectangle {
  T left = std::numeric_limits<T>::infinity(), bottom = std::numeric_limits<T>::infinity();
  T right = -std::numeric_limits<T>::infinity(), top = -std::numeric_limits<T>::infinity();

  constexpr bool empty() const { return !(left <= right && bottom <= top); }
  friend constexpr bool operator==(const ScreenRectangle&, const ScreenRectangle&) = default;

  static constexpr ScreenRectangle everything() {
    constexpr T infinity = std::numeric_limits<T>::infinity();
    return {-infinity, -infinity, infinity, infinity};
  }
};

template <std::floating_point T>
constexpr ScreenRectangle<T> intersection(const ScreenRectangle<T>& a,
                                          const ScreenRectangle<T>& b) {
  return {std::max(a.left, b.left), std::max(a.bottom, b.bottom), std::min(a.right, b.right),
          std::min(a.top, b.top)};
}

// The corners of a box in clip space: bit 0 of the index chooses lower or upper x, bit 1 y, bit 2
// z. Any eight points with those twelve edges that are convex in (x, y, w) will do.
template <std::floating_point T>
struct BoxCorners {
  std::array<Vec4<T>, 8> points;
};

// The corners of a rectangle under a homography, and of a box under a matrix to clip space. A
// transform in T rounds; the bounds are those of the rounded corners.
template <std::floating_point T>
std::array<Vec4<T>, 4> corners(const glm::mat<3, 3, T, glm::defaultp>& homography,
                               const ScreenRectangle<T>& r) {
  const auto at = [&](T x, T y) {
    const Vec3<T> p = homography * Vec3<T>(x, y, T(1));
    return Vec4<T>(p[0], p[1], T(0), p[2]);
  };
  return {at(r.left, r.bottom), at(r.right, r.bottom), at(r.right, r.top), at(r.left, r.top)};
}

template <std::floating_point T>
BoxCorners<T> corners(const glm::mat<4, 4, T, glm::defaultp>& to_clip, const AxisBox<T>& box) {
  BoxCorners<T> r;
  for (std::size_t i = 0; i < 8; ++i) {
    const T x = (i & 1) != 0 ? box.upper[0] : box.lower[0];
    const T y = (i & 2) != 0 ? box.upper[1] : box.lower[1];
    const T z = (i & 4) != 0 ? box.upper[2] : box.lower[2];
    r.points[i] = to_clip * Vec4<T>(x, y, z, T(1));
  }
  return r;
}

// NDC to px: x_px = left + (x + 1) / 2 * (right - left), likewise y from bottom to top. `viewport`
// is where NDC -1 and 1 come to lie; where y_px points down its bottom is greater than its top.
// Infinite bounds stay infinite. Outward: contains the exact rectangle.
template <std::floating_point T>
ScreenRectangle<T> to_px(const ScreenRectangle<T>& viewport, const ScreenRectangle<T>& ndc,
                         Rounding rounding = Rounding::nearest) {
  if (ndc.empty()) return {};
  const auto map = [&](T from, T to, T v, bool down) {
    if (!std::isfinite(v)) return (from <= to) ? v : -v;
    const Enclosure<double> first(from), last(to), at(v);
    const Enclosure<double> share = at + Enclosure<double>(1), rest = Enclosure<double>(1) + -at;
    // from (1 - v) / 2 + to (1 + v) / 2: exact at v = -1 and v = 1.
    const auto term = [](const Enclosure<double>& weight, double end) {
      const Enclosure<double> a = scaled<double>(weight.low < 0 ? -weight : weight, 0.5 * end);
      return weight.low < 0 ? -a : a;
    };
    const Enclosure<double> px = term(rest, from) + term(share, to);
    const double value = rounding == Rounding::nearest ? middle(px) : (down ? px.low : px.high);
    return down ? bounds::rounded_down<T>(value, rounding) : bounds::rounded_up<T>(value, rounding);
  };
  const bool x_up = viewport.left <= viewport.right, y_up = viewport.bottom <= viewport.top;
  return {map(viewport.left, viewport.right, x_up ? ndc.left : ndc.right, true),
          map(viewport.bottom, viewport.top, y_up ? ndc.bottom : ndc.top, true),
          map(viewport.left, viewport.right, x_up ? ndc.right : ndc.left, false),
          map(viewport.bottom, viewport.top, y_up ? ndc.top : ndc.bottom, false)};
}

}  // namespace clipscope

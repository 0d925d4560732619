// SPDX-License-Identifier: MIT
//
// A clip window in the plane, and the plane as the segment clippers see it.
//
// The rectangle is closed: a point on a side is inside. Units are the caller's: px, NDC, anything.
// Outcodes: 4 bits, those of the planes left, right, bottom and top.
#pragma once

#include <glm/vec2.hpp>

#include "spaces/cvv/sutherland_hodgman.hpp"
#include "spaces/segment.hpp"

namespace clipscope {

template <Scalar T>
using Vec2 = glm::vec<2, T, glm::defaultp>;

template <Scalar T>
using Segment2 = std::array<Vec2<T>, 2>;

// The default is the window in NDC.
template <Scalar T>
struct Rectangle {
  T left = T(-1), right = T(1), bottom = T(-1), top = T(1);
};

inline constexpr std::array<Plane, 4> kSides = {Plane::left, Plane::right, Plane::bottom,
                                                Plane::top};
inline constexpr Outcode kSidePlanes =
    bit(Plane::left) | bit(Plane::right) | bit(Plane::bottom) | bit(Plane::top);

// The coordinate, 0 or 1, that is the same everywhere on a side; and its value there.
constexpr int side_axis(Plane side) { return static_cast<int>(side) / 2; }

template <Scalar T>
constexpr const T& side_coordinate(const Rectangle<T>& r, Plane side) {
  switch (side) {
    case Plane::left: return r.left;
    case Plane::right: return r.right;
    case Plane::bottom: return r.bottom;
    default: return r.top;
  }
}

// Signed distance of a point (x, y, ...) to a side: > 0 inside.
template <Scalar T, class Point>
constexpr T side_distance(const Rectangle<T>& r, Plane side, const Point& p) {
  const int axis = side_axis(side);
  if (side == Plane::left || side == Plane::bottom) return p[axis] - side_coordinate(r, side);
  return side_coordinate(r, side) - p[axis];
}

// Compares and computes nothing. A NaN is outside of both sides of its axis.
template <Scalar T, class Point>
constexpr Outcode side_outcode(const Rectangle<T>& r, const Point& p) {
  return static_cast<Outcode>(!(r.left <= p[0])) << 0 |
         static_cast<Outcode>(!(p[0] <= r.right)) << 1 |
         static_cast<Outcode>(!(r.bottom <= p[1])) << 2 |
         static_cast<Outcode>(!(p[1] <= r.top)) << 3;
}

// Points of the plane. A new point gets the coordinate of its side exactly.
template <Scalar T>
class RectangleSpace {
 public:
  using ScalarType = T;
  using PointType = Vec2<T>;

  explicit constexpr RectangleSpace(const Rectangle<T>& rectangle) : rectangle_(rectangle) {}

  constexpr const Rectangle<T>& rectangle() const { return rectangle_; }
  constexpr const Vec2<T>& position(const Vec2<T>& p) const { return p; }
  constexpr Outcode planes() const { return kSidePlanes; }
  constexpr Outcode outcode(const Vec2<T>& p) const { return side_outcode(rectangle_, p); }
  constexpr T distance(Plane side, const Vec2<T>& p) const {
    return side_distance(rectangle_, side, p);
  }
  constexpr Vec2<T> meet(Plane side, const Vec2<T>& inside, const Vec2<T>& outside,
                         const T& t) const {
    const int along = 1 - side_axis(side);
    Vec2<T> r;
    r[side_axis(side)] = side_coordinate(rectangle_, side);
    r[along] = inside[along] + t * (outside[along] - inside[along]);
    return r;
  }
  constexpr Vec2<T> meet_at(Plane, const Vec2<T>&, const Vec2<T>&, const Vec2<T>& at) const {
    return at;
  }

 private:
  Rectangle<T> rectangle_;
};

// Vertices in NDC of which only x and y are looked at; depth, 1/w and attributes follow,
// perspective-correct.
template <Scalar T, int K>
class WindowSegmentSpace {
 public:
  using ScalarType = T;
  using PointType = NdcVertex<T, K>;

  explicit constexpr WindowSegmentSpace(const Rectangle<T>& rectangle) : rectangle_(rectangle) {}

  constexpr const Rectangle<T>& rectangle() const { return rectangle_; }
  constexpr const Vec4<T>& position(const NdcVertex<T, K>& v) const { return v.position; }
  constexpr Outcode planes() const { return kSidePlanes; }
  constexpr Outcode outcode(const NdcVertex<T, K>& v) const {
    return side_outcode(rectangle_, v.position);
  }
  constexpr T distance(Plane side, const NdcVertex<T, K>& v) const {
    return side_distance(rectangle_, side, v.position);
  }
  constexpr NdcVertex<T, K> meet(Plane side, const NdcVertex<T, K>& inside,
                                 const NdcVertex<T, K>& outside, const T& t) const {
    NdcVertex<T, K> r = cvv::interpolate_perspective(inside, outside, t);
    r.position[side_axis(side)] = side_coordinate(rectangle_, side);
    return r;
  }
  constexpr NdcVertex<T, K> meet_at(Plane side, const NdcVertex<T, K>& inside,
                                    const NdcVertex<T, K>& outside, const Vec2<T>& at) const {
    const T t = crossing(distance(side, inside), distance(side, outside));
    NdcVertex<T, K> r = cvv::interpolate_perspective(inside, outside, t);
    r.position[0] = at[0];
    r.position[1] = at[1];
    return r;
  }

 private:
  // Within the segment, although rounding may have moved an end to a side that it does not reach.
  static constexpr T crossing(const T& d_inside, const T& d_outside) {
    if (d_inside == d_outside) return T(0);
    const T t = cut_parameter(d_inside, d_outside);
    if (!(T(0) < t)) return T(0);
    if (!(t < T(1))) return T(1);
    return t;
  }

  Rectangle<T> rectangle_;
};

// A space for methods that compute coordinates of the plane themselves.
//
//   rectangle()                          the window
//   position(p)                          its [0] and [1] are x and y
//   meet_at(side, inside, outside, at)   the point at `at`, on the side; what else a point has is
//                                        that of the segment where it crosses the side
template <class S>
concept PlanarSpace = SegmentSpace<S> && requires(const S space, const typename S::PointType& p,
                                                  const Vec2<typename S::ScalarType>& at) {
  { space.rectangle() } -> std::convertible_to<Rectangle<typename S::ScalarType>>;
  { space.position(p)[0] } -> std::convertible_to<typename S::ScalarType>;
  { space.meet_at(Plane::left, p, p, at) } -> std::same_as<typename S::PointType>;
};

namespace window {

// Whether both coordinates are finite.
template <Scalar T>
constexpr bool is_finite_point(const Vec2<T>& p) {
  return is_finite(p[0]) && is_finite(p[1]);
}

// The part of a segment of the plane that is in the rectangle, in the order of the segment; none if
// at most a point is, or if a coordinate is not finite.
template <class Method, Scalar T>
constexpr std::optional<Segment2<T>> clip(const Method& method, const Rectangle<T>& rectangle,
                                          const Segment2<T>& segment) {
  if (!is_finite_point(segment[0]) || !is_finite_point(segment[1])) return std::nullopt;
  const std::optional<Segment2<T>> rest = method(RectangleSpace<T>(rectangle), segment);
  if (!rest || is_same_position((*rest)[0], (*rest)[1])) return std::nullopt;
  if (!is_finite_point((*rest)[0]) || !is_finite_point((*rest)[1])) return std::nullopt;
  return rest;
}

}  // namespace window

}  // namespace clipscope

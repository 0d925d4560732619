// SPDX-License-Identifier: MIT
//
// The six planes of the view volume as signed-distance forms in every space, and outcodes.
//
// A form d is positive inside, negative outside and 0 on the plane, which belongs to the volume.
// Forms are not normalised: d is the distance times a positive factor of the plane.
//
//           view (perspective)   view (parallel)      clip      ndc
//   left    near x + left z      x + shear z - left   w + x     1 + x
//   right  -near x - right z     right - x - shear z  w - x     1 - x
//   near   -z - near             -z - near            by depth range: z + w, z or w - z
//   far     z + far              z + far              by depth range: w - z, w - z or z
//
// Clip-space and NDC forms: Blinn and Newell, "Clipping Using Homogeneous Coordinates", 1978.
// A NaN makes every comparison with it false and hence its vertex an outside one.
#pragma once

#include <array>
#include <cstdint>

#include "spaces/projection.hpp"

namespace clipscope {

enum class Plane : std::uint8_t { left, right, bottom, top, near, far };

inline constexpr int kPlanes = 6;
inline constexpr std::array<Plane, kPlanes> kAllPlanes = {Plane::left, Plane::right, Plane::bottom,
                                                          Plane::top,  Plane::near,  Plane::far};

// Signed distance form of a plane in view space. With an infinite far plane every point is inside it.
template <Scalar T>
constexpr T view_distance(const Frustum<T>& f, Plane plane, const Vec3<T>& v) {
  const bool perspective = f.kind == ProjectionKind::perspective;
  switch (plane) {
    case Plane::left:
      if (perspective) return f.near * v[0] + f.left * v[2];
      return v[0] + f.shear_x * v[2] - f.left;
    case Plane::right:
      if (perspective) return -(f.near * v[0]) - f.right * v[2];
      return f.right - (v[0] + f.shear_x * v[2]);
    case Plane::bottom:
      if (perspective) return f.near * v[1] + f.bottom * v[2];
      return v[1] + f.shear_y * v[2] - f.bottom;
    case Plane::top:
      if (perspective) return -(f.near * v[1]) - f.top * v[2];
      return f.top - (v[1] + f.shear_y * v[2]);
    case Plane::near: return -v[2] - f.near;
    case Plane::far:
      if (f.infinite_far) return T(1);
      return v[2] + f.far;
  }
  return T(0);
}

// Signed distance form of a plane in clip space: `one` is w there and 1 in NDC.
template <Scalar T>
constexpr T volume_distance(DepthRange depth, Plane plane, const Vec4<T>& v, const T& one) {
  const bool reversed = depth == DepthRange::reversed;
  switch (plane) {
    case Plane::left: return one + v[0];
    case Plane::right: return one - v[0];
    case Plane::bottom: return one + v[1];
    case Plane::top: return one - v[1];
    case Plane::near:
      if (depth == DepthRange::minus_one_to_one) return one + v[2];
      if (reversed) return one - v[2];
      return v[2];
    case Plane::far:
      if (reversed) return v[2];
      return one - v[2];
  }
  return T(0);
}

template <Scalar T>
constexpr T clip_distance(DepthRange depth, Plane plane, const Vec4<T>& v) {
  return volume_distance(depth, plane, v, v[3]);
}

template <Scalar T>
constexpr T ndc_distance(DepthRange depth, Plane plane, const Vec4<T>& v) {
  return volume_distance(depth, plane, v, T(1));
}

// Bit p is set where the point is outside plane p.
using Outcode = std::uint32_t;

constexpr Outcode bit(Plane plane) { return Outcode{1} << static_cast<int>(plane); }

// Outcode in the volume -one <= x, y <= one with the depth range given: comparisons only, hence exact.
template <Scalar T>
constexpr Outcode volume_outcode(DepthRange depth, const Vec4<T>& v, const T& one) {
  const T minus_one = -one;
  const T lowest_z = depth == DepthRange::minus_one_to_one ? minus_one : T(0);
  Outcode code = 0;
  code |= static_cast<Outcode>(!(minus_one <= v[0])) << static_cast<int>(Plane::left);
  code |= static_cast<Outcode>(!(v[0] <= one)) << static_cast<int>(Plane::right);
  code |= static_cast<Outcode>(!(minus_one <= v[1])) << static_cast<int>(Plane::bottom);
  code |= static_cast<Outcode>(!(v[1] <= one)) << static_cast<int>(Plane::top);
  const auto below = static_cast<Outcode>(!(lowest_z <= v[2]));
  const auto above = static_cast<Outcode>(!(v[2] <= one));
  const bool reversed = depth == DepthRange::reversed;
  code |= (reversed ? above : below) << static_cast<int>(Plane::near);
  code |= (reversed ? below : above) << static_cast<int>(Plane::far);
  return code;
}

template <Scalar T>
constexpr Outcode clip_outcode(DepthRange depth, const Vec4<T>& v) {
  return volume_outcode(depth, v, v[3]);
}

template <Scalar T>
constexpr Outcode ndc_outcode(DepthRange depth, const Vec4<T>& v) {
  return volume_outcode(depth, v, T(1));
}

template <Scalar T>
constexpr Outcode view_outcode(const Frustum<T>& f, const Vec3<T>& v) {
  Outcode code = 0;
  for (const Plane plane : kAllPlanes) {
    if (!(T(0) <= view_distance(f, plane, v))) {
      code |= bit(plane);
    }
  }
  return code;
}

// What the outcodes of a triangle's vertices say at once.
struct TriangleOutcode {
  Outcode all;  // planes that every vertex is outside of: any bit set rejects the triangle
  Outcode any;  // planes that some vertex is outside of: no bit set accepts it
};

constexpr TriangleOutcode combine(Outcode a, Outcode b, Outcode c) {
  return {a & b & c, a | b | c};
}

}  // namespace clipscope

// SPDX-License-Identifier: MIT
//
// The planes of the clip volume as signed-distance forms in every space, and outcodes.
//
// A form d is positive inside, negative outside and 0 on the plane, which belongs to the volume
// unless it is an open side (volume.hpp).
// Forms are not normalised: d is the distance times a positive factor of the plane.
//
//           view (perspective)   view (parallel)      clip      ndc
//   left    near x + left z      x + shear z - left   w + x     1 + x
//   right  -near x - right z     right - x - shear z  w - x     1 - x
//   near   -z - near             -z - near            by depth range: z + w, z or w - z
//   far     z + far              z + far              by depth range: w - z, w - z or z
//
// and after these six the clip distances of the volume: plane kPlanes + i is attribute i, in NDC
// divided by w, which makes it linear there.
//
// Clip-space and NDC forms: Blinn and Newell, "Clipping Using Homogeneous Coordinates", 1978.
// A NaN makes every comparison with it false and hence its vertex an outside one.
#pragma once

#include <array>
#include <cstdint>

#include "spaces/products.hpp"
#include "spaces/projection.hpp"

namespace clipscope {

enum class Plane : std::uint8_t { left, right, bottom, top, near, far };

inline constexpr int kPlanes = 6;
inline constexpr int kMaxPlanes = kPlanes + kMaxClipDistances;
inline constexpr std::array<Plane, kPlanes> kAllPlanes = {Plane::left, Plane::right, Plane::bottom,
                                                          Plane::top,  Plane::near,  Plane::far};

constexpr bool is_clip_distance(Plane plane) { return static_cast<int>(plane) >= kPlanes; }
constexpr int clip_distance_index(Plane plane) { return static_cast<int>(plane) - kPlanes; }

// Bit p is set where a point is outside plane p.
using Outcode = std::uint32_t;

constexpr Outcode bit(Plane plane) { return Outcode{1} << static_cast<int>(plane); }

// Whether the code has one plane.
constexpr bool is_single(Outcode code) { return code != 0 && (code & (code - 1)) == 0; }

// The planes that clip in this volume.
constexpr Outcode planes_of(const ClipVolume& volume) {
  const Outcode all = (Outcode{1} << (kPlanes + volume.clip_distances)) - 1;
  const Outcode near = volume.depth_clamp.near ? bit(Plane::near) : 0;
  const Outcode far = volume.depth_clamp.far ? bit(Plane::far) : 0;
  return all & ~(near | far);
}

// The sides that do not own their points.
constexpr Outcode open_planes_of(const ClipVolume& volume) {
  const OpenSides& open = volume.open_sides;
  return (open.left ? bit(Plane::left) : 0) | (open.right ? bit(Plane::right) : 0) |
         (open.bottom ? bit(Plane::bottom) : 0) | (open.top ? bit(Plane::top) : 0);
}

// The value of a user clip plane (a, b, c, d) at a point, for use as a clip distance: inside is
// a x + b y + c z + d >= 0 in view space.
template <Scalar T>
constexpr T user_plane_distance(const Vec4<T>& plane, const Vec3<T>& v) {
  return plane[0] * v[0] + plane[1] * v[1] + plane[2] * v[2] + plane[3];
}

// Signed distance form of a plane in view space. With an infinite far plane every point is inside
// it.
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

// The same from products that are exact or nearly so (spaces/products.hpp): the sign is the exact
// one for the side planes of a perspective frustum, and for all planes where the form is a single
// difference.
template <Scalar T>
constexpr T exact_sign_view_distance(const Frustum<T>& f, Plane plane, const Vec3<T>& v) {
  if (f.kind == ProjectionKind::perspective) {
    switch (plane) {
      case Plane::left: return sum_of_products(f.near, v[0], f.left, v[2]);
      case Plane::right: return -sum_of_products(f.near, v[0], f.right, v[2]);
      case Plane::bottom: return sum_of_products(f.near, v[1], f.bottom, v[2]);
      case Plane::top: return -sum_of_products(f.near, v[1], f.top, v[2]);
      default: break;
    }
  }
  return view_distance(f, plane, v);
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

// The same for a vertex and any plane of the volume, clip distances included.
template <Scalar T, int K>
constexpr T signed_distance(const Frustum<T>& f, Plane plane, const ViewVertex<T, K>& v) {
  if (is_clip_distance(plane)) return v.attributes[clip_distance_index(plane)];
  return view_distance(f, plane, v.position);
}

template <Scalar T, int K>
constexpr T signed_distance(DepthRange depth, Plane plane, const ClipVertex<T, K>& v) {
  if (is_clip_distance(plane)) return v.attributes[clip_distance_index(plane)];
  return clip_distance(depth, plane, v.position);
}

template <Scalar T, int K>
constexpr T signed_distance(DepthRange depth, Plane plane, const NdcVertex<T, K>& v) {
  if (is_clip_distance(plane)) return v.attributes[clip_distance_index(plane)] * v.position[3];
  return ndc_distance(depth, plane, v.position);
}

// Outcode in the volume -one <= x, y <= one with the depth range given: comparisons only, hence
// exact.
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
    if (!(T(0) <= view_distance(f, plane, v))) code |= bit(plane);
  }
  return code;
}

// The bits of the clip distances.
template <Scalar T, int K>
constexpr Outcode clip_distance_outcode(const ClipVolume& volume, const Attributes<T, K>& a) {
  Outcode code = 0;
  for (int i = 0; i < volume.clip_distances; ++i) {
    code |= static_cast<Outcode>(!(T(0) <= a[i])) << (kPlanes + i);
  }
  return code;
}

// What the outcodes of a primitive's vertices say at once, about the planes that clip.
struct OutcodeSummary {
  Outcode all;  // planes that every vertex is outside of: any bit set rejects the primitive
  Outcode any;  // planes that some vertex is outside of: no bit set accepts it
};

// position_outcode(i) gives the bits of the six planes at vertex i.
template <Space S, Scalar T, int K, std::size_t N, class PositionOutcode>
constexpr OutcodeSummary summarize_outcodes(const ClipVolume& volume,
                                            const Simplex<S, T, K, N>& primitive,
                                            PositionOutcode&& position_outcode) {
  OutcodeSummary r{~Outcode{0}, 0};
  const auto note = [&r](Outcode code) {
    r.all &= code;
    r.any |= code;
  };
  if (is_plain(volume)) [[likely]] {
    for (std::size_t i = 0; i < N; ++i) note(position_outcode(i));
    return r;
  }
  for (std::size_t i = 0; i < N; ++i) {
    note(position_outcode(i) | clip_distance_outcode(volume, primitive[i].attributes));
  }
  const Outcode planes = planes_of(volume);
  return {r.all & planes, r.any & planes};
}

template <Scalar T, int K, std::size_t N>
constexpr OutcodeSummary summarize_outcodes(const ClipVolume& volume,
                                            const Simplex<Space::clip, T, K, N>& primitive) {
  return summarize_outcodes(volume, primitive, [&](std::size_t i) {
    return clip_outcode(volume.depth, primitive[i].position);
  });
}

// Calls f(plane) for each plane of the code that is in the order given, then for its clip
// distances.
template <std::size_t N, class F>
constexpr void for_each_plane(Outcode code, const std::array<Plane, N>& order, F&& f) {
  for (const Plane plane : order) {
    if ((code & bit(plane)) != 0) f(plane);
  }
  for (int p = kPlanes; (code >> p) != 0; ++p) {
    const auto plane = static_cast<Plane>(p);
    if ((code & bit(plane)) != 0) f(plane);
  }
}

// The place that `order` gives a plane is the bit that it has here; clip distances come last.
template <std::size_t N>
constexpr Outcode in_order(Outcode code, const std::array<Plane, N>& order) {
  Outcode r = code >> kPlanes << N;
  for (std::size_t i = 0; i < N; ++i) r |= (code >> static_cast<int>(order[i]) & 1) << i;
  return r;
}
template <std::size_t N>
constexpr Plane plane_at(const std::array<Plane, N>& order, int place) {
  const auto i = static_cast<std::size_t>(place);
  return i < N ? order[i] : static_cast<Plane>(kPlanes + i - N);
}

// Whether all vertices of a primitive are on or outside of one open side: then the volume owns
// nothing of it. is_inside(side, i): whether vertex i is strictly inside.
template <class IsInside>
constexpr bool is_beyond_open_side(const ClipVolume& volume, std::size_t vertices,
                                   IsInside&& is_inside) {
  if (!volume.open_sides) [[likely]]
    return false;
  bool is_beyond = false;
  for_each_plane(open_planes_of(volume), kAllPlanes, [&](Plane side) {
    bool reaches_in = false;
    for (std::size_t i = 0; i < vertices; ++i) reaches_in = reaches_in || is_inside(side, i);
    is_beyond = is_beyond || !reaches_in;
  });
  return is_beyond;
}

// Whether a clip position is strictly inside of a side: one comparison, hence exact.
template <Scalar T>
constexpr bool is_inside_side(Plane side, const Vec4<T>& v) {
  switch (side) {
    case Plane::left: return -v[3] < v[0];
    case Plane::right: return v[0] < v[3];
    case Plane::bottom: return -v[3] < v[1];
    default: return v[1] < v[3];
  }
}

// The same of clip positions, or of a clip-space primitive.
template <Scalar T, std::size_t N>
constexpr bool is_beyond_open_side(const ClipVolume& volume,
                                   const std::array<Vec4<T>, N>& positions) {
  return is_beyond_open_side(
      volume, N, [&](Plane side, std::size_t i) { return is_inside_side(side, positions[i]); });
}
template <Scalar T, int K, std::size_t N>
constexpr bool is_beyond_open_side(const ClipVolume& volume,
                                   const Simplex<Space::clip, T, K, N>& primitive) {
  return is_beyond_open_side(volume, N, [&](Plane side, std::size_t i) {
    return is_inside_side(side, primitive[i].position);
  });
}

}  // namespace clipscope

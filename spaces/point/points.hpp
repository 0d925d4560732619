// SPDX-License-Identifier: MIT
//
// Clipping of points that are drawn as squares of a size, with both answers that are legal at the
// sides.
//
//   point/pop       a point whose centre is outside any plane vanishes, its whole square with it
//   point/pop_free  near, far and clip distances ask about the centre; at the sides a point stays
//                   as long as its square, grown from the centre, touches the volume, and comes
//                   strictly inside of an open side
//
// Source: pop: The Khronos Group, "OpenGL 4.6 Core Profile Specification", section 13.7, and
// Vulkan's pointClippingBehavior ALL_CLIP_PLANES; pop-free: OpenGL ES 3.2, "Primitive Clipping"
// (only near and far discard points), and WebGL 1.0, "Wide point primitive clipping", which allows
// either.
// Guarantees: nothing is computed for a point whose centre is inside the sides. A point of size 0
// is treated alike by both.
// Does not guarantee: that a pixel of the square is covered; only that the closed square and the
// closed volume meet, up to rounding.
#pragma once

#include "spaces/clipper.hpp"
#include "spaces/planes.hpp"

namespace clipscope {

// Half the extent of a point's square, in NDC; both >= 0.
template <Scalar T>
struct PointSize {
  T half_width = T(0), half_height = T(0);
};

// A square of size_px in a viewport of width_px times height_px. NDC is 2 wide: half of the size
// times 2 / width.
template <Scalar T>
constexpr PointSize<T> point_size_ndc(const T& size_px, const T& width_px, const T& height_px) {
  const T half_width = size_px / width_px;
  const T half_height = size_px / height_px;
  return {half_width, half_height};
}

enum class PointAtSide { pop, pop_free };

template <PointAtSide kAtSide>
struct PointClipper {
  static constexpr bool kPops = kAtSide == PointAtSide::pop;
  static constexpr std::string_view name = kPops ? "point/pop" : "point/pop_free";
  static constexpr std::string_view summary =
      kPops ? "a point vanishes when its centre leaves the volume"
            : "a point stays until its whole square has left the sides of the volume";
  static constexpr std::string_view source =
      kPops ? "OpenGL 4.6 Core Profile Specification, section 13.7"
            : "OpenGL ES 3.2 Specification, Primitive Clipping";
  // The promise is about points of size 0; the centre of a larger one may lie outside the sides.
  static constexpr Promise promise{.ulps = kProjectUlps, .watertight = true, .confined = kPops};

  // out: no vertex, or the centre, divided.
  template <Scalar T, int K>
  constexpr void operator()(const ClipVolume& volume, const ClipPoint<T, K>& point,
                            const PointSize<T>& size, NdcPolygon<T, K>& out) const {
    out.clear();
    const ClipVertex<T, K>& v = point[0];
    const Outcode code =
        (clip_outcode(volume.depth, v.position) | clip_distance_outcode(volume, v.attributes)) &
        planes_of(volume);
    if (!is_kept(code, v.position, size) || is_beyond(volume, v.position, size)) return;
    // Inside all planes only the eye itself, (0, 0, 0, 0), has w = 0; but depth may have no bound.
    if (!(T(0) < v.position[3]) || !has_finite_position(v)) return;
    out.push_back(to_ndc(v));
    clear_if_overflowed(out);
  }

  template <Scalar T, int K>
  constexpr void operator()(const Projection<T>& projection, const ViewPoint<T, K>& point,
                            const PointSize<T>& size, NdcPolygon<T, K>& out) const {
    (*this)(projection.volume, to_clip(projection, point), size, out);
  }

  // A point of size 0.
  template <Scalar T, int K>
  constexpr void operator()(const ClipVolume& volume, const ClipPoint<T, K>& point,
                            NdcPolygon<T, K>& out) const {
    (*this)(volume, point, PointSize<T>{}, out);
  }

  template <Scalar T, int K>
  constexpr void operator()(const Projection<T>& projection, const ViewPoint<T, K>& point,
                            NdcPolygon<T, K>& out) const {
    (*this)(projection.volume, to_clip(projection, point), PointSize<T>{}, out);
  }

 private:
  template <Scalar T>
  static constexpr bool is_kept(Outcode code, const Vec4<T>& v, const PointSize<T>& size) {
    if (code == 0) return true;
    if constexpr (kPops) {
      return false;
    } else {
      constexpr Outcode x_sides = bit(Plane::left) | bit(Plane::right);
      constexpr Outcode y_sides = bit(Plane::bottom) | bit(Plane::top);
      if ((code & ~(x_sides | y_sides)) != 0) return false;
      return ((code & x_sides) == 0 || touches(v[0], v[3], size.half_width)) &&
             ((code & y_sides) == 0 || touches(v[1], v[3], size.half_height));
    }
  }

  // Whether an open side owns nothing of the square.
  template <Scalar T>
  static constexpr bool is_beyond(const ClipVolume& volume, const Vec4<T>& v,
                                  const PointSize<T>& size) {
    return is_beyond_open_side(volume, 1, [&](Plane side, std::size_t) {
      if constexpr (kPops) return is_inside_side(side, v);
      const bool is_x = side == Plane::left || side == Plane::right;
      const T& half = is_x ? size.half_width : size.half_height;
      const T reach = v[3] + half * v[3];
      return is_inside_side(side, Vec4<T>(v[0], v[1], v[2], reach));
    });
  }

  // Whether |x / w| <= 1 + half, without the division: -(w + half w) <= x <= w + half w.
  template <Scalar T>
  static constexpr bool touches(const T& x, const T& w, const T& half) {
    const T reach = w + half * w;
    return -reach <= x && x <= reach;
  }
};

using PointPop = PointClipper<PointAtSide::pop>;
using PointPopFree = PointClipper<PointAtSide::pop_free>;

}  // namespace clipscope

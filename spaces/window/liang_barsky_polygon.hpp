// SPDX-License-Identifier: MIT
//
// Liang and Barsky's polygon clipper in the window: one pass over the edges, no polygon between.
//
// Each edge enters the two strips between the window's opposite sides and leaves them again, at
// four parameters of which two are entries, known from its direction. The order of these says all:
// if the later entry is before the earlier exit a part is visible and written; if the edge enters
// one strip and has left the other by then it passes around a corner, which is written as a turning
// vertex, and so is the corner that the edge comes to by entering its first strip.
// Source: Liang and Barsky, "An Analysis and Algorithm for Polygon Clipping", CACM 26(11), 1983;
// corrigendum, CACM 27(2), 1984. Its Pascal program was not to be had; here it is as scikit-image
// translated it in 2006 (_clip.c, with a fix from Anti-Grain Geometry: entries are computed before
// they are compared).
// Repaired: the program moves an edge that is parallel to a side off it by a small number; here
// such an edge enters its strip before its beginning and never leaves it, or never enters it. The
// program compares rounded parameters with 0 and 1, so that a vertex an ulp outside is inside of
// one edge and outside of the next, and a bridge is left open; here coordinates are compared, which
// is the same in exact arithmetic. An edge that ends on a side, or touches a corner, gives that
// point once. Turning vertices: see window/border_polygon.hpp.
// Does not guarantee: the same bits on a shared edge from both sides: parameters are measured from
// the end where the edge begins.
#pragma once

#include "spaces/window/border_polygon.hpp"

namespace clipscope {

struct LiangBarskyPolygon {
  template <Scalar T, int K>
  static constexpr void clip(const Rectangle<T>& rectangle, const NdcPolygon<T, K>& polygon,
                             window::BorderPolygon<T, K>& border) {
    for (int i = 0; i < polygon.size(); ++i) {
      clip_edge(rectangle, polygon[i], polygon[(i + 1) % polygon.size()], border);
    }
  }

 private:
  // Where an edge from a to b enters and leaves the strip between two opposite sides: parameters,
  // and what they are beside 0 and 1, asked of coordinates.
  template <Scalar T>
  struct Strip {
    Plane entry, exit;
    T t_in;
    T way_out, length;    // from a to the exit, and to b, along the axis
    bool starts_before;   // 0 < t_in
    bool enters;          // t_in <= 1
    bool ends_beyond_in;  // t_in < 1
    bool starts_after;    // t_out <= 0
    bool leaves;          // t_out < 1

    constexpr T t_out() const {
      if (length == T(0)) return T(2);
      const T t = way_out / length;
      return t;
    }
  };

  template <Scalar T>
  static constexpr Strip<T> strip(const Rectangle<T>& r, Plane low, Plane high, const T& a,
                                  const T& b) {
    const T length = b - a;
    const bool is_parallel = length == T(0);
    const bool up = is_parallel ? !(side_coordinate(r, high) < a) : T(0) < length;
    const Plane entry = up ? low : high, exit = up ? high : low;
    const T& in = side_coordinate(r, entry);
    const T& out = side_coordinate(r, exit);
    const auto is_before = [up](const T& p, const T& q) { return up ? p < q : q < p; };
    Strip<T> s{entry,
               exit,
               T(-1),
               out - a,
               length,
               is_before(a, in),
               !is_before(b, in),
               is_before(in, b),
               !is_parallel && !is_before(a, out),
               is_before(out, b)};
    if (!is_parallel) {
      const T way_in = in - a;
      s.t_in = way_in / length;
    }
    return s;
  }

  template <Scalar T, int K>
  static constexpr void clip_edge(const Rectangle<T>& r, const NdcVertex<T, K>& a,
                                  const NdcVertex<T, K>& b, window::BorderPolygon<T, K>& border) {
    const Strip<T> x = strip(r, Plane::left, Plane::right, a.position[0], b.position[0]);
    const Strip<T> y = strip(r, Plane::bottom, Plane::top, a.position[1], b.position[1]);
    if (!x.enters && !y.enters) return;
    if (x.starts_before && y.starts_before) border.turn({x.entry, y.entry});
    if (!x.enters || !y.enters) return;
    const bool starts_outside = x.starts_before || y.starts_before;
    if (!starts_outside && (x.starts_after || y.starts_after)) return;
    const bool x_is_last_in = x.starts_before && (!y.starts_before || y.t_in < x.t_in);
    const Strip<T>& last_in = x_is_last_in ? x : y;
    const T x_out = x.t_out();
    const T y_out = y.t_out();
    const bool x_is_first_out = x.leaves && (!y.leaves || x_out < y_out);
    const T& t_out = x_is_first_out ? x_out : y_out;
    const bool leaves = x.leaves || y.leaves;
    if (starts_outside) {
      if (leaves && t_out < last_in.t_in) {
        border.turn(x_is_last_in ? window::Corner{x.entry, y.exit}
                                 : window::Corner{x.exit, y.entry});
        return;
      }
      if (leaves ? last_in.t_in < t_out : last_in.ends_beyond_in) {
        border.add(point_on(r, last_in.entry, a, b, last_in.t_in));
      }
    }
    border.add(leaves ? point_on(r, x_is_first_out ? x.exit : y.exit, a, b, t_out) : b);
  }

  // The point at t of the edge, which is on a side.
  template <Scalar T, int K>
  static constexpr NdcVertex<T, K> point_on(const Rectangle<T>& r, Plane side,
                                            const NdcVertex<T, K>& a, const NdcVertex<T, K>& b,
                                            const T& t) {
    NdcVertex<T, K> v = cvv::interpolate_perspective(a, b, t);
    v.position[side_axis(side)] = side_coordinate(r, side);
    return v;
  }
};

struct WindowLiangBarskyPolygon
    : StartsInClipSpace<window::DepthCutThenBorder<LiangBarskyPolygon>> {
  static constexpr std::string_view name = "window/liang_barsky_polygon";
  static constexpr std::string_view summary =
      "near and far cut in clip space, divide, then Liang-Barsky's polygon clipper in 2D";
  static constexpr std::string_view source =
      "Liang and Barsky, An Analysis and Algorithm for Polygon Clipping, 1983";
  static constexpr Promise promise = window::kBorderPromise;
};

}  // namespace clipscope

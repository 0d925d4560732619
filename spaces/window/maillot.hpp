// SPDX-License-Identifier: MIT
//
// Maillot's polygon clipper in the window: Cohen-Sutherland for the edges, a table of outcodes for
// the turning vertices.
//
// Outcodes have a fifth bit that says that two others are set: the vertex is beyond a corner. A
// visible edge is written as Cohen and Sutherland clip it. Of an invisible one the codes of its
// ends name the corner that it passes around: no arithmetic but that of the codes. Only where it
// goes from beyond one corner to beyond the opposite one do midpoints find the corner between.
// Source: Maillot, "A New, Fast Method for 2D Polygon Clipping: Analysis and Software
// Implementation", ACM TOG 11(3), 1992; here as Agoston gives it in "Computer Graphics and
// Geometric Modeling", 2005, tables Tcc and Cra included, by way of a program made after that.
// Repaired: the program as found takes the offset of a midpoint's corner from the code of an end of
// the edge, where the table has none; the midpoint's own code is meant. An edge that touches the
// window in one of its ends is not an invisible one. Turning vertices: see
// window/border_polygon.hpp.
// Guarantees: the midpoints come to an end: each halves the way between the ends, and at the latest
// one between the window's sides is beyond no corner or another one.
// Does not guarantee: the same bits on a shared edge from both sides where both ends are outside.
#pragma once

#include "spaces/cohen_sutherland.hpp"
#include "spaces/window/border_polygon.hpp"

namespace clipscope {

struct MaillotPolygon {
  template <Scalar T, int K>
  static constexpr void clip(const Rectangle<T>& rectangle, const NdcPolygon<T, K>& polygon,
                             window::BorderPolygon<T, K>& border) {
    const WindowSegmentSpace<T, K> space(rectangle);
    int i = polygon.size() - 1;
    int begin = code(rectangle, polygon[i].position);
    for (int next = 0; next < polygon.size(); ++next) {
      const int end = code(rectangle, polygon[next].position);
      clip_edge(rectangle, space, {polygon[i], polygon[next]}, begin, end, border);
      i = next;
      begin = end;
    }
  }

 private:
  static constexpr int kRight = 1, kTop = 2, kLeft = 4, kBottom = 8, kTwoBits = 16;
  // Added to the code of a corner, what leads to the next corner along the side whose code is the
  // index, if that corner is not on the side; 1 where the index is itself a corner.
  static constexpr std::array<int, 16> kOffset = {0, -3, -6, 1, 3, 0, 1, 0, 6, 1, 0, 0, 1, 0, 0, 0};

  template <Scalar T, class Point>
  static constexpr int code(const Rectangle<T>& r, const Point& p) {
    const int x = p[0] < r.left ? kLeft : r.right < p[0] ? kRight : 0;
    const int y = p[1] < r.bottom ? kBottom : r.top < p[1] ? kTop : 0;
    return x | y | (x != 0 && y != 0 ? kTwoBits : 0);
  }
  static constexpr bool is_corner(int code) { return (code & kTwoBits) != 0; }
  static constexpr int sides(int code) { return code & ~kTwoBits; }

  static constexpr window::Corner corner(int code) {
    return {(code & kLeft) != 0 ? Plane::left : Plane::right,
            (code & kBottom) != 0 ? Plane::bottom : Plane::top};
  }

  // From the side `side` to beyond the corner `two`, or back: the corner that is passed around.
  static constexpr int turn(int two, int side) {
    return two + kOffset[static_cast<std::size_t>(side)];
  }

  template <Scalar T, int K>
  static constexpr void clip_edge(const Rectangle<T>& rectangle,
                                  const WindowSegmentSpace<T, K>& space,
                                  const std::array<NdcVertex<T, K>, 2>& edge, int begin, int end,
                                  window::BorderPolygon<T, K>& border) {
    if ((begin | end) == 0) return border.add(edge[1]);
    const auto visible = CohenSutherland{}(space, edge);
    if (visible && begin != 0) border.add((*visible)[0]);
    if (visible || end == 0) {
      border.add(end == 0 ? edge[1] : (*visible)[1]);
    } else if (begin != 0) {
      end = pass_by(rectangle, edge, begin, end, border);
    }
    if (is_corner(end)) border.turn(corner(end));
  }

  // An edge that is not visible: writes the corner that it passes on its way to beyond a corner;
  // returns the code of where it ends, or of the corner that it passes on its way to a side.
  template <Scalar T, int K>
  static constexpr int pass_by(const Rectangle<T>& rectangle,
                               const std::array<NdcVertex<T, K>, 2>& edge, int begin, int end,
                               window::BorderPolygon<T, K>& border) {
    const bool apart = sides(begin & end) == 0;
    if (is_corner(end)) {
      if (!apart) return end;
      border.turn(corner(is_corner(begin) ? corner_between(rectangle, edge, begin, end)
                                          : turn(end, begin)));
      return end;
    }
    if (is_corner(begin)) return apart ? turn(begin, end) : end;
    const int both = begin | end;
    return kOffset[static_cast<std::size_t>(both)] == 1 ? both | kTwoBits : both;
  }

  // The corner that an edge from beyond one corner to beyond the opposite one passes around.
  template <Scalar T, int K>
  static constexpr int corner_between(const Rectangle<T>& rectangle,
                                      const std::array<NdcVertex<T, K>, 2>& edge, int begin,
                                      int end) {
    const T half(0.5f);
    std::array<Vec2<T>, 2> ends;
    for (std::size_t i = 0; i < 2; ++i) ends[i] = {edge[i].position[0], edge[i].position[1]};
    for (;;) {
      const T x = (ends[0][0] + ends[1][0]) * half;
      const T y = (ends[0][1] + ends[1][1]) * half;
      const Vec2<T> middle(x, y);
      const int at = code(rectangle, middle);
      if (at == begin) {
        ends[0] = middle;
      } else if (at == end) {
        ends[1] = middle;
      } else {
        return is_corner(at) ? at
               : at == 0     ? nearest_corner(rectangle, middle)
                             : turn((at & end) != 0 ? begin : end, at);
      }
    }
  }

  // For a point in the window, of an edge that does no more than touch it.
  template <Scalar T>
  static constexpr int nearest_corner(const Rectangle<T>& r, const Vec2<T>& p) {
    const T to_left = p[0] - r.left, to_right = r.right - p[0];
    const T to_bottom = p[1] - r.bottom, to_top = r.top - p[1];
    return (to_left < to_right ? kLeft : kRight) | (to_bottom < to_top ? kBottom : kTop) | kTwoBits;
  }
};

struct WindowMaillot : StartsInClipSpace<window::DepthCutThenBorder<MaillotPolygon>> {
  static constexpr std::string_view name = "window/maillot";
  static constexpr std::string_view summary =
      "near and far cut in clip space, divide, then Maillot's table of outcodes in 2D";
  static constexpr std::string_view source =
      "Maillot, A New, Fast Method for 2D Polygon Clipping, 1992";
  static constexpr Promise promise = window::kBorderPromise;
};

}  // namespace clipscope

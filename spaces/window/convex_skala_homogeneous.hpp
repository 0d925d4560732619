// SPDX-License-Identifier: MIT
//
// Skala's S-clip for segments in a convex polygon: bit codes of the vertices, lines and points by
// cross products of homogeneous coordinates.
//
// The segment's line is the cross product of its ends, (x, y, 1). Its scalar product with a vertex
// tells the side: a bit for each vertex, independent of all others. Where the code and the code
// moved on by a bit differ, the line crosses an edge. The points that it meets there are the cross
// products of the line with the edges' lines, divided once, and they take the place of ends outside
// of these edges.
// Source: Skala, "A Novel Line Convex Polygon Clipping Algorithm in E2 with Parallel Processing
// Modification", ICCSA 2021, LNCS 12953, known by its abstract and by accounts of the S-clip family
// in Skala, "A Brief Survey of Clipping and Intersection Algorithms with a List of References",
// Informatica 34(1), 2023.
// What the closed window adds: a line along an edge is found by window::edges_against.
// Guarantees: no comparison of parameters, two points divided at most, all vertices treated alike.
// Does not guarantee: the size of the error far from the origin, where the products of coordinates
// cancel; the order of the ends where the line passes within rounding of a vertex; the same bits
// for a segment and its reverse.
#pragma once

#include <bit>
#include <cstdint>

#include "spaces/window/convex_window.hpp"

namespace clipscope {

struct ConvexSkalaHomogeneous {
  static constexpr std::string_view name = "convex/skala_homogeneous";
  static constexpr std::string_view summary =
      "a bit for each vertex by the homogeneous line, points by cross products";
  static constexpr std::string_view source =
      "Skala, A Novel Line Convex Polygon Clipping Algorithm in E2, 2021";

  template <Scalar T>
  constexpr std::optional<Segment2<T>> operator()(const ConvexWindow<T>& window,
                                                  const Segment2<T>& segment) const {
    const Vec3<T> line = line_through(segment[0], segment[1]);
    const std::optional<window::EdgePair> pair = crossed(window, segment, line);
    if (!pair) return std::nullopt;
    Segment2<T> ends = segment;
    if (!replace(window, pair->in, line, segment, 0, ends)) return std::nullopt;
    if (!replace(window, pair->out, line, segment, 1, ends)) return std::nullopt;
    return window::if_segment(ends);
  }

 private:
  static constexpr std::size_t kWord = 64;

  template <Scalar T>
  static constexpr Vec3<T> line_through(const Vec2<T>& p, const Vec2<T>& q) {
    const T x = p[1] - q[1];
    const T y = q[0] - p[0];
    const T w = p[0] * q[1] - p[1] * q[0];
    return Vec3<T>(x, y, w);
  }

  // > 0 to the left of the line.
  template <Scalar T>
  static constexpr T side(const Vec3<T>& line, const Vec2<T>& p) {
    return line[0] * p[0] + line[1] * p[1] + line[2];
  }

  // The edges where the code changes, 64 vertices at a time.
  template <Scalar T>
  static constexpr std::optional<window::EdgePair> crossed(const ConvexWindow<T>& window,
                                                           const Segment2<T>& segment,
                                                           const Vec3<T>& line) {
    const std::size_t n = window.size();
    std::optional<std::size_t> in, out, on;
    std::uint64_t carry = T(0) < side(line, window.vertex(n - 1)) ? 1 : 0;
    for (std::size_t first = 0; first < n; first += kWord) {
      const std::size_t count = std::min(kWord, n - first);
      std::uint64_t code = 0;
      for (std::size_t k = 0; k < count; ++k) {
        const T s = side(line, window.vertex(first + k));
        code |= static_cast<std::uint64_t>(T(0) < s) << k;
        if (s == T(0)) on = first + k;
      }
      std::uint64_t changes = code ^ (code << 1 | carry);
      if (count < kWord) changes &= (std::uint64_t{1} << count) - 1;
      for (; changes != 0; changes &= changes - 1) {
        const auto k = static_cast<std::size_t>(std::countr_zero(changes));
        ((code >> k & 1) != 0 ? out : in) = window.wrapped(first + k + n - 1);
      }
      carry = code >> (count - 1);
    }
    if (in && out) return window::EdgePair{*in, *out};
    if (on) return window::edges_against(window, DirectedLine<T>(segment), *on);
    return std::nullopt;
  }

  // Puts the point where the line meets an edge in the place of an end that is outside of it.
  // Returns whether anything is inside of the edge.
  template <Scalar T>
  static constexpr bool replace(const ConvexWindow<T>& window, std::size_t edge,
                                const Vec3<T>& line, const Segment2<T>& segment, std::size_t end,
                                Segment2<T>& ends) {
    const Vec3<T> e = line_through(window.vertex(edge), window.vertex(edge + 1));
    if (T(0) <= side(e, segment[end])) return true;
    if (!(T(0) < side(e, segment[1 - end]))) return false;
    const T x = line[1] * e[2] - line[2] * e[1];
    const T y = line[2] * e[0] - line[0] * e[2];
    const T w = line[0] * e[1] - line[1] * e[0];
    if (!can_divide_by(w)) return false;
    ends[end][0] = x / w;
    ends[end][1] = y / w;
    return true;
  }
};

}  // namespace clipscope

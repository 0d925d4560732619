// SPDX-License-Identifier: MIT
//
// A window that is a convex polygon, and what the methods that clip segments by it share.
//
// The vertices run counter-clockwise, so the inside is to the left of every edge. The window is
// closed: a point on an edge is inside. Edge i runs from vertex i to the next one; its inner normal
// is made once per window (two subtractions for each edge) and not of length 1.
//
// A segment's line cuts the boundary in two: vertices to the left of the line, and those to the
// right of it or on it. Where the boundary passes from left to right the line comes in, where it
// passes back the line goes out. That names the two edges that can cut, and methods differ in how
// they find them. A line that no vertex is left of, but that passes through two, runs along an
// edge, against its direction (edges_against).
//
// The answer is the part that is inside, in the order of the segment; none if at most a point is,
// or if a coordinate is not finite.
// Does not guarantee: in rounded arithmetic, the right side of the line for a vertex that is within
// rounding of it.
#pragma once

#include <algorithm>
#include <optional>
#include <span>

#include "spaces/parametric_bounds.hpp"
#include "spaces/window/rectangle.hpp"

namespace clipscope {

template <Scalar T>
class DualSubdivision;  // dual_subdivision.hpp

// Pre-condition: at least three vertices, strictly convex, counter-clockwise, the lowest first (of
// two lowest the left one), each with the normal of its edge. They belong to the caller.
template <Scalar T>
class ConvexWindow {
 public:
  // dual: for the method that needs it (convex_dual.hpp).
  constexpr ConvexWindow(std::span<const Vec2<T>> vertices, std::span<const Vec2<T>> normals,
                         const DualSubdivision<T>* dual = nullptr)
      : vertices_(vertices), normals_(normals), dual_(dual) {}

  constexpr std::size_t size() const { return vertices_.size(); }
  // Numbers go round: i < 2 size().
  constexpr std::size_t wrapped(std::size_t i) const { return i < size() ? i : i - size(); }
  constexpr const Vec2<T>& vertex(std::size_t i) const { return vertices_[wrapped(i)]; }
  constexpr const Vec2<T>& normal(std::size_t edge) const { return normals_[wrapped(edge)]; }

  constexpr const DualSubdivision<T>* dual() const { return dual_; }

  // Signed distance form of an edge: > 0 inside; 0, on the edge's line, is inside.
  constexpr T distance(std::size_t edge, const Vec2<T>& p) const {
    const Vec2<T>& n = normal(edge);
    const Vec2<T>& v = vertex(edge);
    return n[0] * (p[0] - v[0]) + n[1] * (p[1] - v[1]);
  }
  constexpr Vec2<T> meet(std::size_t, const Vec2<T>& inside, const Vec2<T>& outside,
                         const T& t) const {
    Vec2<T> r;
    for (int i = 0; i < 2; ++i) r[i] = inside[i] + t * (outside[i] - inside[i]);
    return r;
  }

 private:
  std::span<const Vec2<T>> vertices_, normals_;
  const DualSubdivision<T>* dual_;
};

// The precomputation. Turns the polygon so that its lowest vertex is the first, and makes the
// normals. Pre-condition: strictly convex, counter-clockwise; as many normals as vertices.
template <Scalar T>
constexpr ConvexWindow<T> prepare_window(std::span<Vec2<T>> vertices, std::span<Vec2<T>> normals) {
  const auto is_lower = [](const Vec2<T>& a, const Vec2<T>& b) {
    return a[1] < b[1] || (a[1] == b[1] && a[0] < b[0]);
  };
  std::rotate(vertices.begin(), std::min_element(vertices.begin(), vertices.end(), is_lower),
              vertices.end());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec2<T>& from = vertices[i];
    const Vec2<T>& to = vertices[i + 1 < vertices.size() ? i + 1 : 0];
    normals[i][0] = from[1] - to[1];
    normals[i][1] = to[0] - from[0];
  }
  return {vertices, normals};
}

// The line of a segment.
template <Scalar T>
class DirectedLine {
 public:
  explicit constexpr DirectedLine(const Segment2<T>& s) : point_(s[0]) {
    for (int i = 0; i < 2; ++i) direction_[i] = s[1][i] - s[0][i];
  }

  constexpr const Vec2<T>& direction() const { return direction_; }
  // > 0 to the left of the line, < 0 to the right.
  constexpr T side(const Vec2<T>& v) const {
    return direction_[0] * (v[1] - point_[1]) - direction_[1] * (v[0] - point_[0]);
  }

 private:
  Vec2<T> point_, direction_;
};

namespace window {

// The edges by which a line comes into the window and goes out of it.
struct EdgePair {
  std::size_t in, out;
};

// What is left of a segment, if it is one.
template <Scalar T>
constexpr std::optional<Segment2<T>> if_segment(const Segment2<T>& s) {
  if (is_same_position(s[0], s[1])) return std::nullopt;
  for (const Vec2<T>& p : s) {
    if (!is_finite(p[0]) || !is_finite(p[1])) return std::nullopt;
  }
  return s;
}

// The part of a segment between the edges by which its line comes in and goes out.
template <Scalar T>
constexpr std::optional<Segment2<T>> cut_by_pair(const ConvexWindow<T>& window,
                                                 const Segment2<T>& segment,
                                                 const std::optional<EdgePair>& pair) {
  if (!pair) return std::nullopt;
  ParametricBounds<T, std::size_t> bounds;
  for (const std::size_t edge : {pair->in, pair->out}) {
    if (!bounds.cut(edge, window.distance(edge, segment[0]), window.distance(edge, segment[1]))) {
      return std::nullopt;
    }
  }
  return if_segment(bounds.move_ends(window, segment));
}

// The pair of a line that no vertex is left of and that passes through vertex i: the neighbours of
// the edge that it runs along; none if it touches the vertex alone.
template <Scalar T>
constexpr std::optional<EdgePair> edges_against(const ConvexWindow<T>& window,
                                                const DirectedLine<T>& line, std::size_t i) {
  const std::size_t n = window.size();
  const std::size_t next = window.wrapped(i + 1), previous = window.wrapped(i + n - 1);
  if (line.side(window.vertex(next)) == T(0)) return EdgePair{next, previous};
  if (line.side(window.vertex(previous)) == T(0)) return EdgePair{i, window.wrapped(i + n - 2)};
  return std::nullopt;
}

}  // namespace window

}  // namespace clipscope

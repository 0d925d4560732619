// SPDX-License-Identifier: MIT
//
// What polygon clippers of the window that walk around its border share: their way there, and the
// polygon that they write.
//
// Near, far and clip distances cut in clip space, then comes the divide, then the method clips x
// and y. Such a method writes corners of the window, *turning vertices*, wherever the polygon may
// pass around one, and so leaves bridges along the border that go to a corner and back, with no
// area. The contract has no place for them: a vertex is a point of the triangle and carries its
// attributes. So a corner between two vertices on one and the same side is dropped as the polygon
// is written. Of a convex polygon only corners are left then that are inside of it.
// Source: bridges of no area: Liang and Barsky, "An Analysis and Algorithm for Polygon Clipping",
// CACM 26(11), 1983. Attributes: Blinn, "Hyperbolic Interpolation", IEEE CG&A 12(4), 1992.
// Does not guarantee: an answer where w <= 0 is left after the cut by near and far.
#pragma once

#include "spaces/clipper.hpp"
#include "spaces/cut.hpp"
#include "spaces/window/rectangle.hpp"

namespace clipscope::window {

// A corner of the window by its two sides.
struct Corner {
  Plane x_side = Plane::left, y_side = Plane::bottom;
};

// The polygon that a method writes, vertex by vertex.
template <Scalar T, int K>
class BorderPolygon {
 public:
  explicit constexpr BorderPolygon(const Rectangle<T>& rectangle) : rectangle_(rectangle) {}

  constexpr void add(const NdcVertex<T, K>& v) { push({v, false}); }

  constexpr void turn(const Corner& corner) {
    Entry entry{{}, true};
    entry.vertex.position[0] = side_coordinate(rectangle_, corner.x_side);
    entry.vertex.position[1] = side_coordinate(rectangle_, corner.y_side);
    push(entry);
  }

  // Writes the polygon, with the corners that are left as points of the polygon `of`.
  constexpr void finish(const NdcPolygon<T, K>& of, NdcPolygon<T, K>& out) {
    close();
    out.clear();
    for (const Entry& e : entries_) {
      if (!e.is_corner) {
        out.push_back(e.vertex);
      } else if (const auto v = point_of(of, e.vertex.position)) {
        out.push_back(*v);
      }
    }
    out.drop_if_degenerate();
    clear_if_overflowed(out);
  }

 private:
  struct Entry {
    NdcVertex<T, K> vertex;
    bool is_corner;
  };

  constexpr void push(const Entry& e) {
    while (!entries_.empty() && is_bridge_to(entries_.size() - 1, e)) drop_last();
    if (!(e.is_corner && !entries_.empty() && is_same_point(last(), e))) entries_.push_back(e);
  }

  // Whether entry i is a corner that nothing is lost without, when e follows it.
  constexpr bool is_bridge_to(int i, const Entry& e) const {
    if (!entries_[i].is_corner) return false;
    return is_same_point(entries_[i], e) || (i > 0 && shares_side(entries_[i - 1], entries_[i], e));
  }

  // The same where the end of the list meets its beginning.
  constexpr void close() {
    while (entries_.size() > 1) {
      const int n = entries_.size();
      if (last().is_corner && (is_same_point(last(), entries_[0]) ||
                               shares_side(entries_[n - 2], last(), entries_[0]))) {
        drop_last();
      } else if (entries_[0].is_corner && (is_same_point(last(), entries_[0]) ||
                                           shares_side(last(), entries_[0], entries_[1]))) {
        for (int i = 1; i < n; ++i) entries_[i - 1] = entries_[i];
        drop_last();
      } else {
        break;
      }
    }
  }

  constexpr const Entry& last() const { return entries_[entries_.size() - 1]; }
  constexpr void drop_last() { entries_.truncate(entries_.size() - 1); }

  static constexpr bool is_same_point(const Entry& a, const Entry& b) {
    return a.vertex.position[0] == b.vertex.position[0] &&
           a.vertex.position[1] == b.vertex.position[1];
  }

  // Whether all three lie on a side of the window, to which the second, a corner, belongs.
  static constexpr bool shares_side(const Entry& a, const Entry& corner, const Entry& b) {
    for (int axis = 0; axis < 2; ++axis) {
      const T& side = corner.vertex.position[axis];
      if (a.vertex.position[axis] == side && b.vertex.position[axis] == side) return true;
    }
    return false;
  }

  // The vertex of a convex polygon at a corner inside of it: between the two points where the
  // vertical through the corner meets the polygon. None if it does not.
  constexpr std::optional<NdcVertex<T, K>> point_of(const NdcPolygon<T, K>& polygon,
                                                    const Vec4<T>& corner) const {
    std::optional<NdcVertex<T, K>> low, high;
    const auto note = [&](const NdcVertex<T, K>& v) {
      if (!low || v.position[1] < low->position[1]) low = v;
      if (!high || high->position[1] < v.position[1]) high = v;
    };
    for (int i = 0; i < polygon.size(); ++i) {
      const NdcVertex<T, K>& a = polygon[i];
      const NdcVertex<T, K>& b = polygon[(i + 1) % polygon.size()];
      const T d_a = a.position[0] - corner[0];
      const T d_b = b.position[0] - corner[0];
      if (d_a == T(0)) note(a);
      if (d_a < T(0) && T(0) < d_b) note(meet(b, a, d_b, d_a));
      if (d_b < T(0) && T(0) < d_a) note(meet(a, b, d_a, d_b));
    }
    if (!low) return std::nullopt;
    NdcVertex<T, K> r = between(*low, *high, corner[1]);
    r.position[0] = corner[0];
    r.position[1] = corner[1];
    return r;
  }

  static constexpr NdcVertex<T, K> meet(const NdcVertex<T, K>& a, const NdcVertex<T, K>& b,
                                        const T& d_a, const T& d_b) {
    const T t = cut_parameter(d_a, d_b);
    return cvv::interpolate_perspective(a, b, t);
  }

  // At height y, or the end of the segment that is nearest to it.
  static constexpr NdcVertex<T, K> between(const NdcVertex<T, K>& low, const NdcVertex<T, K>& high,
                                           const T& y) {
    const T above_low = y - low.position[1];
    const T above_high = y - high.position[1];
    if (!(T(0) < above_low)) return low;
    if (!(above_high < T(0))) return high;
    return meet(low, high, above_low, above_high);
  }

  Rectangle<T> rectangle_;
  VertexList<Entry> entries_;
};

// Cuts a triangle by near, far and clip distances in clip space and divides. Nothing is left of it
// where a vertex has w <= 0 or is not finite after the cut.
template <Scalar T, int K>
constexpr void cut_depth_and_divide(const ClipVolume& volume, Outcode planes,
                                    const ClipTriangle<T, K>& triangle, NdcPolygon<T, K>& out) {
  out.clear();
  if (!has_finite_positions(triangle)) return;
  ClipPolygon<T, K> polygon, scratch;
  polygon.assign(triangle);
  const ClipPolygon<T, K>& rest = cut_by_planes(polygon, scratch, planes & ~kSidePlanes, kAllPlanes,
                                                [&](Plane plane, const ClipVertex<T, K>& v) {
                                                  return signed_distance(volume.depth, plane, v);
                                                });
  for (const ClipVertex<T, K>& v : rest) {
    if (!(T(0) < v.position[3])) {
      out.clear();
      return;
    }
    out.push_back(to_ndc(v));
  }
  out.drop_if_degenerate();
  clear_if_overflowed(out);
}

// Outcodes accept and reject. The rest: depth in clip space, divide, and if a side cuts the static
// Method::clip(rectangle, polygon, border) writes to a BorderPolygon what is in the rectangle.
template <class Method>
struct DepthCutThenBorder {
  template <Scalar T, int K>
  static constexpr void clip(const ClipVolume& volume, const ClipTriangle<T, K>& triangle,
                             NdcPolygon<T, K>& out) {
    const OutcodeSummary code = summarize_outcodes(volume, triangle);
    out.clear();
    if (code.all != 0) return;
    if ((code.any & kSidePlanes) == 0) return cut_depth_and_divide(volume, code.any, triangle, out);
    NdcPolygon<T, K> polygon;
    cut_depth_and_divide(volume, code.any, triangle, polygon);
    if (polygon.empty()) return;
    const Rectangle<T> rectangle;
    BorderPolygon<T, K> border(rectangle);
    Method::clip(rectangle, polygon, border);
    border.finish(polygon, out);
  }
};

// The promise of such a method: in clip space two cuts of kChainUlps, in the window an edge is cut
// once or twice, and a corner is between two such points. With another vertex first the walk may go
// around the border in another way, where coordinates are so large that differences lose digits.
inline constexpr Promise kBorderPromise{.domain = Promise::Domain::divisible,
                                        .ulps = kChainUlps,
                                        .amplification = Promise::Amplification::w_ratio,
                                        .rotation_invariant = false,
                                        .depth_clamp = false};

}  // namespace clipscope::window

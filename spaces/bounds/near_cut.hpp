// SPDX-License-Identifier: MIT
//
// The screen rectangle of what the near plane leaves of a convex polygon or a box.
//
// The near plane is d >= 0 by depth range: z + w, z, or w - z (planes.hpp). What it leaves is the
// convex hull of the vertices with d >= 0 and, on each edge from a to b across it, of the point
// |d_b| a + |d_a| b: Sutherland and Hodgman, "Reentrant Polygon Clipping", 1974. Where all of these
// have w > 0, their quotients bound it. If the near plane lets w <= 0 through, as that of a matrix
// without perspective may, the rectangle is that of the part with w > 0 (projected_bounds.hpp).
//
// Guarantees (round-to-nearest, gradual underflow, no FMA contraction; float and double): the
// rectangle contains all (x/w, y/w) of the primitive's points with w > 0 and d >= 0, so if it is
// empty, there is none. The sign of d is exact at each vertex. NaN or infinity among the
// coordinates: everything may be covered.
// Does not guarantee: the tightest rectangle; each bound is a few units in the last place of double
// off, and then rounded outwards to T.
#pragma once

#include "spaces/bounds/culling_hull.hpp"
#include "spaces/bounds/projected_bounds.hpp"

namespace clipscope {

namespace bounds {

// The value of the near plane at a clip position: z + w, z or w - z.
template <std::floating_point T>
Enclosure<double> near_distance(DepthRange depth, const Vec4<T>& v) {
  const double z = v[2], w = v[3];
  if (depth == DepthRange::zero_to_one) return Enclosure<double>(z);
  return depth == DepthRange::reversed ? sum(w, -z) : sum(z, w);
}

// Its sign: what rounds to 0 is 0, since the least difference of two numbers is one.
inline int sign_of(const Enclosure<double>& e) { return e.high < 0 ? -1 : (e.low > 0 ? 1 : 0); }

// The extents of x/w and y/w over generators with w > 0.
class NearExtents {
 public:
  void add(const Enclosure<double>& x, const Enclosure<double>& y, const Enclosure<double>& w) {
    in_front_ = in_front_ && w.low > 0;
    if (!in_front_) return;
    x_.add(x / w);
    y_.add(y / w);
  }
  bool are_in_front() const { return in_front_; }

  template <std::floating_point T>
  ScreenRectangle<T> rectangle() const {
    if (x_.empty()) return {};
    constexpr Rounding outward = Rounding::outward;
    return {rounded_down<T>(x_.least, outward), rounded_down<T>(y_.least, outward),
            rounded_up<T>(x_.greatest, outward), rounded_up<T>(y_.greatest, outward)};
  }

 private:
  Extent<double> x_, y_;
  bool in_front_ = true;
};

template <std::floating_point T, class Edges>
ScreenRectangle<T> projected_bounds_beyond_near(DepthRange depth, std::span<const Vec4<T>> points,
                                                const Edges& edges) {
  const auto is_finite = [](const Vec4<T>& v) { return std::isfinite(v[2]); };
  if (!are_finite(points) || !std::all_of(points.begin(), points.end(), is_finite)) {
    return ScreenRectangle<T>::everything();
  }
  NearExtents r;
  for (const Vec4<T>& v : points) {
    if (sign_of(near_distance(depth, v)) >= 0) {
      r.add(Enclosure<double>(v[0]), Enclosure<double>(v[1]), Enclosure<double>(v[3]));
    }
  }
  edges.for_each([&](std::size_t i, std::size_t j) {
    const Vec4<T>&a = points[i], &b = points[j];
    const Enclosure<double> at_a = near_distance(depth, a), at_b = near_distance(depth, b);
    if (sign_of(at_a) * sign_of(at_b) >= 0) return;
    const Enclosure<double> to_a = at_b.high < 0 ? -at_b : at_b;
    const Enclosure<double> to_b = at_a.high < 0 ? -at_a : at_a;
    const auto meet = [&](int c) {
      return scaled<double>(to_a, a[c]) + scaled<double>(to_b, b[c]);
    };
    r.add(meet(0), meet(1), meet(3));
  });
  return r.are_in_front() ? r.template rectangle<T>()
                          : projected_bounds(points, edges, Rounding::outward);
}

}  // namespace bounds

// Of a convex planar polygon, vertices in clip space in order. One vertex is a point, two are a
// segment.
template <std::floating_point T>
ScreenRectangle<T> projected_bounds_beyond_near(DepthRange depth,
                                                std::span<const Vec4<T>> polygon) {
  return bounds::projected_bounds_beyond_near(depth, polygon, bounds::PolygonEdges{polygon.size()});
}

// Of a box.
template <std::floating_point T>
ScreenRectangle<T> projected_bounds_beyond_near(DepthRange depth, const BoxCorners<T>& box) {
  return bounds::projected_bounds_beyond_near(depth, std::span<const Vec4<T>>(box.points),
                                              bounds::BoxEdges{});
}

}  // namespace clipscope

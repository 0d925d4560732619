// SPDX-License-Identifier: MIT
//
// The bounds of a projected primitive: the tight screen rectangle of a convex polygon or a box
// after the perspective divide, the part with w <= 0 cut away.
//
// What is bounded: the closed set V of all (x/w, y/w) of the primitive's points with w > 0, a
// convex set. With the vertices in clip space v_i = (x_i, y_i, w_i), each edge crossing w = 0 met
// in a point c_j = (x_j, y_j, 0), V is the convex hull of the v_i/w_i with w_i > 0, extended
// without end along each c_j. Hence, for x (and likewise for y, and for the least value):
//
//   - no w_i > 0: V is empty;
//   - some x_j > 0: the greatest x is +infinity;
//   - else it is the largest x_i/w_i with w_i > 0. A c_j = (0, 0, 0) adds nothing: x/w has a limit
//     where x and w go to 0 together, and that limit is the value at the edge's end.
//
// The sign of x_j on the edge from a to b is that of x_b w_a - x_a w_b: the sign is taken exactly.
//
// Within a rectangle R: V cut by R is the convex hull of the v_i/w_i inside R and of what V has in
// common with R's four sides. On the line of a side, V is again such a set, one dimension lower:
// its generators are the points where edges meet the plane y = t w (or x = t w).
// Cutting a homogeneous polygon by w > 0 and by x = t w: Blinn and Newell, "Clipping Using
// Homogeneous Coordinates", SIGGRAPH 1978.
//
// Guarantees (round-to-nearest, gradual underflow, no FMA contraction; float and double):
//   - projected_bounds: each bound is the exact one, rounded once to nearest; with
//     Rounding::outward it is the nearest number not inside of it. Every decision is exact. It is
//     infinite or empty exactly if the exact one is, but for a quotient that overflows when
//     rounded.
//   - projected_bounds_within, outward: contains V cut by R. So if it is empty, nothing is visible.
//   - projected_bounds_within, nearest: the same computed in double and rounded to T in the end.
//   - NaN or infinity among x, y and w: everything may be covered: (-inf, inf), or R.
// Does not guarantee: that results within R are tight where that is a matter of the last bits of
// double: where V touches R within rounding, or where a side meets an edge next to x = y = w = 0, R
// or a side of it may be the answer. In float that takes an edge through the eye, and next to all
// bounds are the exact ones, correctly rounded; in double most are, or are a few units in the last
// place off. Coordinates in double beyond 1e100 or below 1e-100 may loosen bounds.
// There is no near or far plane here: cut the primitive first if only what they leave counts.
// The sign of a matrix matters: under M and -M the same points are visible from opposite sides of w
// = 0, so a primitive with all w < 0 is empty. Negate a homography that is known up to its sign
// only.
#pragma once

#include <span>

#include "spaces/bounds/screen_rectangle.hpp"

namespace clipscope {

namespace bounds {

// Calls f(i, j) for each edge of a polygon of n vertices.
struct PolygonEdges {
  std::size_t count;
  template <class F>
  void for_each(F&& f) const {
    for (std::size_t i = 0; i < count; ++i) f(i, i + 1 < count ? i + 1 : 0);
  }
};

struct BoxEdges {
  template <class F>
  void for_each(F&& f) const {
    for (std::size_t i = 0; i < 8; ++i) {
      for (const std::size_t bit : {std::size_t{1}, std::size_t{2}, std::size_t{4}}) {
        if ((i & bit) == 0) f(i, i | bit);
      }
    }
  }
};

template <std::floating_point T>
bool are_finite(std::span<const Vec4<T>> points) {
  return std::all_of(points.begin(), points.end(), [](const Vec4<T>& v) {
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[3]);
  });
}

// A set of numbers on the extended line: least to greatest; empty if they are in the wrong order.
template <std::floating_point T>
struct Extent {
  T least = std::numeric_limits<T>::infinity(), greatest = -std::numeric_limits<T>::infinity();

  bool empty() const { return !(least <= greatest); }
  void add(const Enclosure<T>& e) {
    least = std::min(least, e.low);
    greatest = std::max(greatest, e.high);
  }
};

// v / w, as the rounding asks for: one number, or two that contain the exact one.
// Pre-condition: w > 0.
template <std::floating_point T>
Enclosure<T> quotient(const Enclosure<T>& v, const Enclosure<T>& w, Rounding rounding) {
  return rounding == Rounding::nearest ? Enclosure<T>(middle(v) / middle(w)) : v / w;
}
template <std::floating_point T>
Enclosure<T> quotient(T v, T w, Rounding rounding) {
  if (rounding == Rounding::nearest) return Enclosure<T>(v / w);
  const Enclosure<double> q = quotient<double>(v, w);
  return {rounded_down<T>(q.low, rounding), rounded_up<T>(q.high, rounding)};
}

// The extent of coordinate `axis` after the divide.
template <std::floating_point T, class Edges>
Extent<T> projected_extent(std::span<const Vec4<T>> points, const Edges& edges, int axis,
                           Rounding rounding) {
  constexpr T infinity = std::numeric_limits<T>::infinity();
  Extent<T> r;
  for (const Vec4<T>& v : points) {
    if (v[3] > T(0)) r.add(quotient(v[axis], v[3], rounding));
  }
  if (r.empty()) return r;
  const auto extend = [&](int direction) {
    if (direction > 0) r.greatest = infinity;
    if (direction < 0) r.least = -infinity;
  };
  for (const Vec4<T>& v : points) {
    if (v[3] == T(0)) extend(v[axis] > T(0) ? 1 : (v[axis] < T(0) ? -1 : 0));
  }
  edges.for_each([&](std::size_t i, std::size_t j) {
    const bool forward = points[i][3] > T(0);
    const Vec4<T>& a = forward ? points[i] : points[j];
    const Vec4<T>& b = forward ? points[j] : points[i];
    if (a[3] > T(0) && b[3] < T(0)) extend(compare_products(b[axis], a[3], a[axis], b[3]));
  });
  return r;
}

template <std::floating_point T, class Edges>
ScreenRectangle<T> projected_bounds(std::span<const Vec4<T>> points, const Edges& edges,
                                    Rounding rounding) {
  if (!are_finite(points)) return ScreenRectangle<T>::everything();
  const Extent<T> x = projected_extent(points, edges, 0, rounding);
  const Extent<T> y = projected_extent(points, edges, 1, rounding);
  return {x.least, y.least, x.greatest, y.greatest};
}

// The set V on a line, from its generators (g, w): points g/w, and directions g where w = 0.
// Generators with w < 0 are the far ends of edges through w = 0.
class LineSection {
 public:
  explicit LineSection(Rounding rounding) : rounding_(rounding) {}

  void add(const Enclosure<double>& g, const Enclosure<double>& w) {
    if (g.is_nan() || w.is_nan()) {
      unknown_ = true;
    } else if (w.low > 0) {
      points_.add(quotient(g, w, rounding_));
    } else if (w.high < 0) {
      beyond_.add(quotient(-g, -w, rounding_));
    } else if (w.low == 0 && w.high == 0) {
      up_ = up_ || g.high > 0;
      down_ = down_ || g.low < 0;
    } else {
      unknown_ = true;
    }
  }

  // From a generator at p > 0 to one at q < 0 the edge passes w = 0 with g > 0 if q's quotient is
  // less than p's: (g_q w_p - g_p w_q) > 0 divided by w_p w_q < 0.
  Extent<double> extent() const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (unknown_) return {-infinity, infinity};
    Extent<double> r = points_;
    if (r.empty()) return r;
    if (up_ || beyond_.least < points_.greatest) r.greatest = infinity;
    if (down_ || points_.least < beyond_.greatest) r.least = -infinity;
    return r;
  }

 private:
  Rounding rounding_;
  Extent<double> points_, beyond_;
  bool up_ = false, down_ = false, unknown_ = false;
};

// |t w - v|, whose sign is known not to be 0, with a relative error of a few units: the product's
// rounding error is added last, and where p - v cancels, that difference is exact.
inline Enclosure<double> magnitude_of_difference(double t, double w, double v) {
  const double p = t * w;
  const auto [difference, rest] = two_sum(p, -v);
  Enclosure<double> error(std::fma(t, w, -p));
  if (t != 0 && w != 0 && std::abs(p) < kSafe<double>) {
    error = {next_below(error.low), next_above(error.high)};
  }
  Enclosure<double> d = Enclosure<double>(difference) + (Enclosure<double>(rest) + error);
  if (difference < 0 || (difference == 0 && d.low < 0)) d = -d;
  return {std::max(d.low, 0.0), d.high};
}

// What V has on the line `fixed` = t, by the coordinate `free`.
template <std::floating_point T, class Edges>
Extent<double> section(std::span<const Vec4<T>> points, const Edges& edges, int fixed, T t,
                       Rounding rounding) {
  const int free = 1 - fixed;
  LineSection r(rounding);
  const auto side = [&](const Vec4<T>& v) { return compare_products(t, v[3], v[fixed], T(1)); };
  for (const Vec4<T>& v : points) {
    if (side(v) == 0) r.add(Enclosure<double>(v[free]), Enclosure<double>(v[3]));
  }
  edges.for_each([&](std::size_t i, std::size_t j) {
    const Vec4<T>&a = points[i], &b = points[j];
    if (side(a) * side(b) < 0) {
      const Enclosure<double> to_a = magnitude_of_difference(t, a[3], a[fixed]);
      const Enclosure<double> to_b = magnitude_of_difference(t, b[3], b[fixed]);
      const auto meet = [&](int axis) {
        return scaled<double>(to_b, a[axis]) + scaled<double>(to_a, b[axis]);
      };
      r.add(meet(free), meet(3));
    }
  });
  return r.extent();
}

// Whether v, with w > 0, is projected into the rectangle: exactly.
template <std::floating_point T>
bool is_within(const ScreenRectangle<T>& r, const Vec4<T>& v) {
  return compare_products(r.left, v[3], v[0], T(1)) <= 0 &&
         compare_products(r.right, v[3], v[0], T(1)) >= 0 &&
         compare_products(r.bottom, v[3], v[1], T(1)) <= 0 &&
         compare_products(r.top, v[3], v[1], T(1)) >= 0;
}

template <std::floating_point T, class Edges>
ScreenRectangle<T> projected_bounds_within(const ScreenRectangle<T>& rectangle,
                                           std::span<const Vec4<T>> points, const Edges& edges,
                                           Rounding rounding) {
  if (rectangle.empty()) return {};
  if (!are_finite(points)) return rectangle;
  const std::array<Extent<double>, 2> range = {Extent<double>{rectangle.left, rectangle.right},
                                               Extent<double>{rectangle.bottom, rectangle.top}};
  std::array<Extent<double>, 2> r;
  for (const Vec4<T>& v : points) {
    if (v[3] > T(0) && is_within(rectangle, v)) {
      for (std::size_t i = 0; i < 2; ++i) {
        r[i].add(quotient<double>(v[static_cast<int>(i)], v[3], rounding));
      }
    }
  }
  const auto add_side = [&](std::size_t fixed, T t) {
    const std::size_t free = 1 - fixed;
    const Extent<double> s = section(points, edges, static_cast<int>(fixed), t, rounding);
    const double least = std::max(s.least, range[free].least);
    const double greatest = std::min(s.greatest, range[free].greatest);
    if (least <= greatest) {
      r[free].add({least, greatest});
      r[fixed].add(Enclosure<double>(t));
    }
  };
  add_side(0, rectangle.left);
  add_side(0, rectangle.right);
  add_side(1, rectangle.bottom);
  add_side(1, rectangle.top);
  if (r[0].empty()) return {};
  return {std::max(rounded_down<T>(r[0].least, rounding), rectangle.left),
          std::max(rounded_down<T>(r[1].least, rounding), rectangle.bottom),
          std::min(rounded_up<T>(r[0].greatest, rounding), rectangle.right),
          std::min(rounded_up<T>(r[1].greatest, rounding), rectangle.top)};
}

}  // namespace bounds

// The bounds of the visible part of a convex planar polygon, vertices (x, y, z, w) in order; z is
// not looked at. One vertex is a point, two are a segment.
// A polygon that isn't convex or planar: the bounds contain the visible part of each of its edges.
template <std::floating_point T>
ScreenRectangle<T> projected_bounds(std::span<const Vec4<T>> polygon,
                                    Rounding rounding = Rounding::nearest) {
  return bounds::projected_bounds(polygon, bounds::PolygonEdges{polygon.size()}, rounding);
}

// The same for a box.
template <std::floating_point T>
ScreenRectangle<T> projected_bounds(const BoxCorners<T>& box,
                                    Rounding rounding = Rounding::nearest) {
  return bounds::projected_bounds(std::span<const Vec4<T>>(box.points), bounds::BoxEdges{},
                                  rounding);
}

// The bounds of what is visible within a rectangle, the viewport say: at most that rectangle.
// Pre-condition: the rectangle is finite, or empty.
template <std::floating_point T>
ScreenRectangle<T> projected_bounds_within(const ScreenRectangle<T>& rectangle,
                                           std::span<const Vec4<T>> polygon,
                                           Rounding rounding = Rounding::nearest) {
  return bounds::projected_bounds_within(rectangle, polygon, bounds::PolygonEdges{polygon.size()},
                                         rounding);
}

template <std::floating_point T>
ScreenRectangle<T> projected_bounds_within(const ScreenRectangle<T>& rectangle,
                                           const BoxCorners<T>& box,
                                           Rounding rounding = Rounding::nearest) {
  return bounds::projected_bounds_within(rectangle, std::span<const Vec4<T>>(box.points),
                                         bounds::BoxEdges{}, rounding);
}

}  // namespace clipscope

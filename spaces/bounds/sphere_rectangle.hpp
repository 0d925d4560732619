// SPDX-License-Identifier: MIT
//
// The screen rectangle of a sphere under any matrix to clip space: its part with w <= 0 cut away,
// and if wanted what lies before the near plane.
//
// A bound s of x/w is a plane X - s W = 0 that touches the sphere, X and W being rows of the
// matrix: with their values x and w at the centre and their normals n and m,
//
//   (x - s w)^2 = r^2 |n - s m|^2.
//
// Under a perspective projection that is the tangent through the eye of Mara and McGuire, "2D
// Polyhedral Bounds of a Clipped, Perspective-Projected 3D Sphere", JCGT 2(2), 2013. Where w = 0
// meets the sphere, the quadratic has no root, or leaves one side unbounded. Where the near plane
// cuts the point of contact away, the bound is that of the disc in which the plane meets the
// sphere: the same quadratic in that plane.
//
// Guarantees (round-to-nearest, gradual underflow, no FMA contraction; float and double): the
// rectangle contains all (x/w, y/w) of the exact sphere's points with w > 0, and beyond the near
// plane, under the exact matrix as given. Every number is kept between two bounds in double
// (enclosure.hpp), and a case that these do not settle takes the larger rectangle. So if it is
// empty, nothing is visible. NaN, infinity and overflow: everything may be covered.
// Does not guarantee: the tightest rectangle. Bounds are some units in the last place of double
// off, more where the sphere nearly touches w = 0, and then rounded outwards to T.
#pragma once

#include "spaces/bounds/near_cut.hpp"

namespace clipscope {

namespace bounds {

using Number = Enclosure<double>;
using Range = Extent<double>;

constexpr Range kWholeLine = {-std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::infinity()};

// The forms X and W over a ball or a disc around a centre: values there, products of normals
// (within the plane of a disc), and the square of the radius.
struct Pencil {
  Number x, w, xx, xw, ww, square_radius;

  // The square of the normal of X - s W.
  Number normal_square(const Number& s) const { return xx - Number(2) * s * xw + square(s) * ww; }
};

// The values of X / W, where W > 0, and the exact ends between two bounds.
struct QuotientRange {
  Range values;
  Number least, greatest;  // if `values` has them
  bool in_front = false;   // W > 0 everywhere
};

inline Number intersection(const Number& a, const Number& b) {
  return {std::max(a.low, b.low), std::min(a.high, b.high)};
}

// p / q for a q that is not 0.
inline Number signed_quotient(const Number& p, const Number& q) {
  return q.high < 0 ? -p / -q : p / q;
}

// The root (b + root) / a = c / (b - root) by whichever is settled, or both.
inline Number root_of(const Number& a, const Number& b, const Number& c, const Number& root) {
  const Number direct = signed_quotient(b + root, a), rest = b - root;
  if (rest.low <= 0 && rest.high >= 0) return direct;
  return intersection(direct, signed_quotient(c, rest));
}

inline QuotientRange quotient_range(const Pencil& p) {
  const QuotientRange unsettled{kWholeLine, {}, {}, false};
  const Number a = square(p.w) - p.square_radius * p.ww;
  const Number b = p.x * p.w - p.square_radius * p.xw;
  const Number c = square(p.x) - p.square_radius * p.xx;
  // b^2 - a c, from terms that cancel less.
  const Number inner = square(p.w) * p.xx - Number(2) * p.x * p.w * p.xw + square(p.x) * p.ww -
                       p.square_radius * (p.xx * p.ww - square(p.xw));
  const Number discriminant = p.square_radius * inner;
  if (a.low > 0) {
    if (p.w.high < 0) return {{}, {}, {}, false};
    if (!(p.w.low > 0) || discriminant.is_nan()) return unsettled;
    const Number root = square_root(discriminant);
    const Number least = root_of(a, b, c, -root), greatest = root_of(a, b, c, root);
    return {{least.low, greatest.high}, least, greatest, true};
  }
  if (!(a.high < 0) || !(discriminant.low > 0)) return unsettled;
  // Between the roots X - s W has one sign all over the sphere; -root comes first since a < 0.
  const Number root = square_root(discriminant), at = signed_quotient(b, a);
  const Number side = p.x - at * p.w;
  QuotientRange r = unsettled;
  if (side.high < 0) {
    r.greatest = root_of(a, b, c, root);
    r.values.greatest = r.greatest.high;
  } else if (side.low > 0) {
    r.least = root_of(a, b, c, -root);
    r.values.least = r.least.low;
  }
  return r;
}

// The near plane N over the same ball: its value at the centre, and its normal's products.
struct NearForm {
  Number n, nn, xn, wn;
};

// Where the near plane meets the ball: a disc around the foot of the centre.
inline Pencil disc_of(const Pencil& p, const NearForm& f) {
  const auto share = [&](const Number& a, const Number& b) { return a * b / f.nn; };
  const Number square_radius = p.square_radius - square(f.n) / f.nn;
  return {p.x - share(f.n, f.xn),
          p.w - share(f.n, f.wn),
          p.xx - share(f.xn, f.xn),
          p.xw - share(f.xn, f.wn),
          p.ww - share(f.wn, f.wn),
          {std::max(square_radius.low, 0.0), std::max(square_radius.high, 0.0)}};
}

// Whether the near plane certainly cuts away the point where X - s W = 0 touches the ball.
inline bool is_contact_cut(const Pencil& p, const NearForm& f, const Number& s) {
  const Number square = p.normal_square(s);
  if (!(square.low > 0)) return false;
  const Number at = f.n - (p.x - s * p.w) * (f.xn - s * f.wn) / square;
  return at.high < 0;
}

// What is left of the values beyond the near plane, or more.
inline Range beyond_near(const Pencil& p, const NearForm& f) {
  const QuotientRange ball = quotient_range(p);
  const Number margin = square(f.n) - p.square_radius * f.nn;
  if (margin.low > 0 && f.n.high < 0) return {};
  const bool is_whole = margin.low > 0 && f.n.low > 0;
  if (is_whole || !(f.nn.low > 0) || ball.values.empty()) return ball.values;
  const QuotientRange disc = quotient_range(disc_of(p, f));
  // The point of least W, if W > 0 is not true all over the ball.
  const Number lowest = f.n - square_root(p.square_radius) * f.wn / square_root(p.ww);
  if (!disc.in_front || !(ball.in_front || lowest.high < 0)) return ball.values;
  const auto is_cut = [&](double bound, const Number& s) {
    return std::isinf(bound) || is_contact_cut(p, f, s);
  };
  Range r = ball.values;
  if (is_cut(r.greatest, ball.greatest)) r.greatest = std::min(r.greatest, disc.values.greatest);
  if (is_cut(r.least, ball.least)) r.least = std::max(r.least, disc.values.least);
  return r;
}

// A form's value at a point.
inline Number value_at(const Row4& form, const std::array<Number, 3>& p) {
  return form[0] * p[0] + form[1] * p[1] + form[2] * p[2] + form[3];
}
// The product of two forms' normals.
inline Number normal_product(const Row4& a, const Row4& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <std::floating_point T>
Row4 exact_row(const Vec4<T>& row) {
  return {Number(row[0]), Number(row[1]), Number(row[2]), Number(row[3])};
}

// near: a row, or null for no cut.
template <std::floating_point T>
ScreenRectangle<T> projected_bounds(const MatrixRows<T>& rows, const Sphere<T>& sphere,
                                    const Row4* near) {
  if (is_empty(sphere)) return {};
  if (!is_finite(sphere)) return ScreenRectangle<T>::everything();
  const std::array<Number, 3> centre = {Number(sphere.centre[0]), Number(sphere.centre[1]),
                                        Number(sphere.centre[2])};
  const Row4 w = exact_row(rows[3]);
  const auto range = [&](const Vec4<T>& row) {
    const Row4 x = exact_row(row);
    const Pencil p = {value_at(x, centre),  value_at(w, centre),  normal_product(x, x),
                      normal_product(x, w), normal_product(w, w), square(Number(sphere.radius))};
    if (near == nullptr) return quotient_range(p).values;
    return beyond_near(p, {value_at(*near, centre), normal_product(*near, *near),
                           normal_product(x, *near), normal_product(w, *near)});
  };
  const Range x = range(rows[0]), y = range(rows[1]);
  const auto is_nan = [](const Range& r) { return std::isnan(r.least) || std::isnan(r.greatest); };
  if (is_nan(x) || is_nan(y)) return ScreenRectangle<T>::everything();
  if (x.empty() || y.empty()) return {};
  constexpr Rounding outward = Rounding::outward;
  return {rounded_down<T>(x.least, outward), rounded_down<T>(y.least, outward),
          rounded_up<T>(x.greatest, outward), rounded_up<T>(y.greatest, outward)};
}

}  // namespace bounds

// Row i of the matrix yields clip coordinate i.
template <std::floating_point T>
ScreenRectangle<T> projected_bounds(const MatrixRows<T>& rows, const Sphere<T>& sphere) {
  return bounds::projected_bounds(rows, sphere, nullptr);
}

template <std::floating_point T>
ScreenRectangle<T> projected_bounds_beyond_near(DepthRange depth, const MatrixRows<T>& rows,
                                                const Sphere<T>& sphere) {
  const bounds::Row4 near = bounds::plane_rows(depth, rows)[static_cast<std::size_t>(Plane::near)];
  return bounds::projected_bounds(rows, sphere, &near);
}

}  // namespace clipscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/bounds/rectangle.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

namespace clipscope::experiments::bounds {
namespace {

using reference::Dyadic;
using reference::Fraction;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A clip position without rounding: x, y, z, w.
using ExactClip = std::array<Dyadic, 4>;

ExactClip exact_clip(const MatrixRows<float>& rows, const reference::ExactPoint& p) {
  ExactClip r;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec4<float>& row = rows[i];
    r[i] = Dyadic(double{row[3]});
    for (std::size_t c = 0; c < 3; ++c) r[i] += Dyadic(double{row[static_cast<int>(c)]}) * p[c];
  }
  return r;
}

Dyadic near_distance(DepthRange depth, const ExactClip& v) {
  if (depth == DepthRange::zero_to_one) return v[2];
  return depth == DepthRange::reversed ? Dyadic(v[3] - v[2]) : Dyadic(v[2] + v[3]);
}

// What a half-space leaves of a hull: the points inside, and where a line from one inside to one
// outside meets its plane, up to a positive factor.
template <class Distance>
std::vector<ExactClip> cut(const std::vector<ExactClip>& points, const Distance& distance) {
  std::vector<ExactClip> r;
  for (const ExactClip& a : points) {
    const Dyadic at_a = distance(a);
    if (at_a.sign() < 0) continue;
    r.push_back(a);
    for (const ExactClip& b : points) {
      const Dyadic at_b = distance(b);
      if (at_b.sign() >= 0) continue;
      ExactClip& meet = r.emplace_back();
      for (std::size_t c = 0; c < 4; ++c) meet[c] = at_a * b[c] - at_b * a[c];
    }
  }
  return r;
}

// The least (sign -1) or greatest (1) quotient of a coordinate by w > 0; points with w = 0 are
// directions without end.
double end_of(const std::vector<ExactClip>& points, std::size_t axis, int sign) {
  std::optional<Fraction> most;
  bool endless = false;
  for (const ExactClip& v : points) {
    const Dyadic x = sign > 0 ? v[axis] : Dyadic(-v[axis]);
    endless = endless || (v[3].sign() == 0 && x.sign() > 0);
    if (v[3].sign() <= 0) continue;
    if (!most || most->numerator * v[3] < x * most->denominator) most = Fraction{x, v[3]};
  }
  assert(most);
  // Plus 0: no end is -0.
  return sign * (endless ? kInfinity : reference::round_to<double>(*most)) + 0.0;
}

BoxCorners<float> clip_corners(const Region& region, const Solid& solid) {
  BoxCorners<float> r;
  const Bound bound = bounds_of(solid).front();
  for (std::size_t i = 0; i < 8; ++i) {
    Vec3<float> p;
    if (const auto* box = std::get_if<AxisBox<float>>(&bound.volume)) {
      for (int c = 0; c < 3; ++c) p[c] = (i >> c & 1) != 0 ? box->upper[c] : box->lower[c];
    } else {
      const auto& oriented = std::get<OrientedBox<float>>(bound.volume);
      p = oriented.centre;
      for (std::size_t k = 0; k < 3; ++k) {
        p += (i >> k & 1) != 0 ? oriented.axes[k] : -oriented.axes[k];
      }
    }
    r.points[i] = to_clip(region.rows, p);
  }
  return r;
}

constexpr ScreenRectangle<float> kScreen = {-1, -1, 1, 1};

// within(screen), all(): the two rectangles of a polygon or box.
template <class Primitive>
ScreenRectangle<float> part_of(DepthRange depth, const Primitive& primitive, Part part) {
  if (part == Part::in_front) return projected_bounds(primitive, Rounding::outward);
  const ScreenRectangle<float> beyond = projected_bounds_beyond_near(depth, primitive);
  if (part == Part::beyond_near || beyond.empty()) return beyond;
  return intersection(beyond, projected_bounds_within(kScreen, primitive, Rounding::outward));
}

ScreenRectangle<float> part_of(const Region& region, const Sphere<float>& sphere, Part part) {
  if (part == Part::in_front) return projected_bounds(region.rows, sphere);
  const ScreenRectangle<float> beyond =
      projected_bounds_beyond_near(region.depth, region.rows, sphere);
  return part == Part::beyond_near ? beyond : intersection(beyond, kScreen);
}

template <class T>
RectangleRow row_of(const std::string& solid, const std::string& part, const std::string& unit,
                    const ScreenRectangle<T>& r) {
  const auto text = [&](T v) { return r.empty() ? std::string("-") : fmt::format("{:.9g}", v); };
  return {solid, part, unit, text(r.left), text(r.bottom), text(r.right), text(r.top)};
}

}  // namespace

ScreenRectangle<float> rectangle_of(const Region& region, const Solid& solid, Part part) {
  if (solid.kind == SolidKind::sphere) {
    return part_of(region, std::get<Sphere<float>>(bounds_of(solid).front().volume), part);
  }
  if (solid.kind != SolidKind::polygon) {
    return part_of(region.depth, clip_corners(region, solid), part);
  }
  std::vector<Vec4<float>> vertices;
  for (const Vec3<float>& p : points_of(solid)) vertices.push_back(to_clip(region.rows, p));
  return part_of(region.depth, std::span<const Vec4<float>>(vertices), part);
}

ExactRectangle exact_rectangle(const Region& region, const Solid& solid, Part part) {
  assert(solid.kind != SolidKind::sphere && part != Part::on_screen);
  std::vector<ExactClip> points;
  for (const reference::ExactPoint& p : exact_hull(solid)) {
    points.push_back(exact_clip(region.rows, p));
  }
  if (part == Part::beyond_near) {
    points = cut(points, [&](const ExactClip& v) { return near_distance(region.depth, v); });
  }
  points = cut(points, [](const ExactClip& v) { return v[3]; });
  const auto is_in_front = [](const ExactClip& v) { return v[3].sign() > 0; };
  if (std::ranges::none_of(points, is_in_front)) return std::nullopt;
  return ScreenRectangle<double>{end_of(points, 0, -1), end_of(points, 1, -1), end_of(points, 0, 1),
                                 end_of(points, 1, 1)};
}

std::vector<RectangleRow> rectangle_rows(const Region& region, const Solid& solid,
                                         const std::optional<std::array<double, 2>>& viewport) {
  static constexpr std::array<const char*, 3> kParts = {"w > 0", "beyond near", "on screen"};
  std::vector<RectangleRow> rows;
  const auto add = [&]<class T>(const std::string& part, const ScreenRectangle<T>& r) {
    rows.push_back(row_of(solid.name, part, "NDC", r));
    if (!viewport) return;
    const ScreenRectangle<T> px = {T(0), static_cast<T>((*viewport)[1]),
                                   static_cast<T>((*viewport)[0]), T(0)};
    rows.push_back(row_of(solid.name, part, "px", to_px(px, r, Rounding::outward)));
  };
  for (const Part part : {Part::in_front, Part::beyond_near, Part::on_screen}) {
    const std::string name = kParts[static_cast<std::size_t>(part)];
    add(name, rectangle_of(region, solid, part));
    if (solid.kind == SolidKind::sphere || part == Part::on_screen) continue;
    const ExactRectangle exact = exact_rectangle(region, solid, part);
    add(name + ", exact", exact.value_or(ScreenRectangle<double>{}));
  }
  return rows;
}

}  // namespace clipscope::experiments::bounds

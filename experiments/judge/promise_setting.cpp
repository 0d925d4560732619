// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/promise_setting.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/judge/containment.hpp"
#include "spaces/projection.hpp"

namespace clipscope::experiments {
namespace {

constexpr double kHeadroom = 8;  // sums of a few terms

// The smallest w of the primitive's part in the volume, the eye (0, 0, 0, 0) included, in doubles.
// Nothing is known of clip distances here: they can only make the part smaller.
double smallest_visible_w(const ClipVolume& volume, const RoundedCorners& corners) {
  using Point = std::array<double, 4>;
  std::vector<Point> polygon(corners.begin(), corners.end());
  const auto keep = [&](auto&& distance) {
    std::vector<Point> rest;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point& a = polygon[i];
      const Point& b = polygon[(i + 1) % polygon.size()];
      const double d_a = distance(a), d_b = distance(b);
      if (d_a >= 0) rest.push_back(a);
      if ((d_a < 0) != (d_b < 0)) {
        Point p;
        for (std::size_t c = 0; c < 4; ++c) p[c] = (d_b * a[c] - d_a * b[c]) / (d_b - d_a);
        rest.push_back(p);
      }
    }
    polygon = rest;
  };
  for (std::size_t c = 0; c < 2; ++c) {
    keep([c](const Point& p) { return p[3] + p[c]; });
    keep([c](const Point& p) { return p[3] - p[c]; });
  }
  const DepthBounds is_bounded(volume);
  const bool gl = volume.depth == DepthRange::minus_one_to_one;
  if (is_bounded.high) keep([](const Point& p) { return p[3] - p[2]; });
  if (is_bounded.low) keep([gl](const Point& p) { return gl ? p[3] + p[2] : p[2]; });
  double smallest = std::numeric_limits<double>::infinity();
  for (const Point& p : polygon) smallest = std::min(smallest, p[3]);
  return smallest;
}

// Whether a vertex leaves the format when it is divided.
bool overflows_divided(const RoundedCorners& corners, double largest) {
  return std::ranges::any_of(corners, [&](const std::array<double, 4>& p) {
    const double reach = largest * std::abs(p[3]);
    return std::abs(p[0]) >= reach || std::abs(p[1]) >= reach || std::abs(p[2]) >= reach;
  });
}

// divisible: no vertex has w = 0.
bool is_in_domain(Promise::Domain domain, const WRange& w, bool divisible) {
  switch (domain) {
    case Promise::Domain::any: return true;
    case Promise::Domain::divisible: return w.smallest > 0;
    case Promise::Domain::in_front: return w.in_front && w.smallest > 0;
    case Promise::Domain::all_or_nothing: return divisible;
  }
  return true;
}

}  // namespace

FrustumRange::FrustumRange(const Frustum<double>& f) {
  smallest_entry = std::numeric_limits<double>::infinity();
  largest_entry = 0;
  for (const Vec4<Exact>& row : rows_of(Projection<Exact>(frustum_cast<Exact>(f)))) {
    for (int i = 0; i < 4; ++i) {
      if (row[i] == Exact(0)) continue;
      const double entry = std::abs(nearest_double(row[i]));
      smallest_entry = std::min(smallest_entry, entry);
      largest_entry = std::max(largest_entry, entry);
    }
  }
  const bool perspective = f.kind == ProjectionKind::perspective;
  if (perspective) narrowest = std::min(f.right - f.left, f.top - f.bottom);
  largest_sum =
      std::max({std::abs(f.left) + std::abs(f.right), std::abs(f.bottom) + std::abs(f.top),
                2 * std::abs(f.near), f.infinite_far ? 0 : std::abs(f.far) + std::abs(f.near)});
  steepest =
      perspective
          ? std::max({std::abs(f.left), std::abs(f.right), std::abs(f.bottom), std::abs(f.top)}) /
                f.near
          : std::max(std::abs(f.shear_x), std::abs(f.shear_y));
}

bool FrustumRange::fits(const Format& format, double magnitude) const {
  if (format.is_exact()) return true;
  const double largest = format.largest();
  const double normal = std::ldexp(1.0, format.min_exponent);
  if (narrowest * magnitude < kHeadroom * normal) return false;
  return smallest_entry >= normal && largest_entry <= largest &&
         largest_sum < largest + format.ulp_at(largest) / 2 &&
         kHeadroom * steepest * steepest <= largest;
}

Corners corners_of(const reference::Truth& truth,
                   std::span<const reference::InputVertex> vertices) {
  Corners corners;
  for (const reference::InputVertex& v : vertices) {
    const auto& exact = corners.exact.emplace_back(truth.clip_position(v));
    std::ranges::transform(exact, corners.rounded.emplace_back().begin(),
                           [](const Exact& x) { return nearest_double(x); });
    corners.divisible = corners.divisible && exact[3] != Exact(0);
  }
  return corners;
}

WRange w_in_front(DepthRange depth, const RoundedCorners& corners) {
  const auto near_distance = [&](const std::array<double, 4>& p) {
    if (depth == DepthRange::minus_one_to_one) return p[3] + p[2];
    return depth == DepthRange::zero_to_one ? p[2] : p[3] - p[2];
  };
  WRange range;
  const auto note = [&](double w) {
    range.smallest = std::min(range.smallest, w);
    range.largest = std::max(range.largest, w);
  };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto& a = corners[i];
    const auto& b = corners[(i + 1) % corners.size()];
    const double d_a = near_distance(a), d_b = near_distance(b);
    range.in_front = range.in_front && d_a >= 0;
    if (d_a >= 0) note(a[3]);
    if ((d_a < 0) != (d_b < 0)) note(a[3] + d_a / (d_a - d_b) * (b[3] - a[3]));
  }
  return range;
}

Exact attribute_scale(const Promise& promise, const Format& format, const PromiseSetting& s) {
  if (s.largest_attribute == 0) return Exact(0);
  if (format.is_exact()) return Exact(Exact(s.magnitude) / Exact(s.largest_attribute));
  const double u = format.unit_roundoff(), eta = format.smallest();
  const bool divided = promise.amplification == Promise::Amplification::w_ratio;
  const double underflow = divided ? eta * std::max(1.0, s.w.largest) : eta;
  return Exact(Exact(u * s.magnitude + eta) / Exact(u * s.largest_attribute + underflow));
}

bool speaks_of(const Promise& promise, const ClipVolume& volume, const PromiseSetting& s,
               const Format& format, double intermediate) {
  const double largest = format.largest();
  if (kHeadroom * std::max(intermediate, s.largest_attribute) > largest) return false;
  if (!is_in_domain(promise.domain, s.w, s.corners.divisible)) return false;
  if (promise.domain == Promise::Domain::all_or_nothing) {
    return !overflows_divided(s.corners.rounded, largest);
  }
  const double smallest_w = smallest_visible_w(volume, s.corners.rounded);
  return s.tolerance < s.magnitude && smallest_w > 2 * s.tolerance && smallest_w * largest > 1;
}

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/depth/pseudo_depth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/contestants/scalars.hpp"
#include "reference/truth.hpp"

namespace clipscope::experiments {
namespace {

using reference::Rational;
using reference::to_rational;

struct Range {
  float near, far;

  template <class N>
  N depth(DepthForm form, const N& d) const {
    return depth_ndc<N>(form, d, N(near), N(far));
  }
  float random_distance(Random& random) const {
    return std::clamp(static_cast<float>(random.across_magnitudes(near, far)), near, far);
  }
};

template <class N>
void check_order(const Range& range, DepthForm form, float nearer, float farther, bool strict,
                 DepthCheck& check) {
  const N a = range.depth<N>(form, N(nearer)), b = range.depth<N>(form, N(farther));
  ++check.samples;
  check.violations += strict ? !(a < b) : b < a;
  const N drop = a - b;
  check.deviation_ndc = std::max(check.deviation_ndc, nearest_double(drop));
}

// An edge by the distances of its ends, seen at s in [0, 1] between their images on the screen.
struct Edge {
  Rational from, to;

  // 1/d is linear on the screen.
  Rational distance_at(const Rational& s) const {
    const Rational inverse = (1 - s) / from + s / to;
    const Rational distance = 1 / inverse;
    return distance;
  }
  Rational interpolated_depth(const Range& range, DepthForm form, const Rational& s) const {
    const Rational a = range.depth<Rational>(form, from), b = range.depth<Rational>(form, to);
    const Rational depth = (1 - s) * a + s * b;
    return depth;
  }
};

Edge random_edge(const Range& range, Random& random) {
  const float from = range.random_distance(random);
  const float to = range.random_distance(random);
  return {to_rational(double{from}), to_rational(double{to})};
}

// The distance that a depth of the form belongs to; the inverse of depth_ndc.
Rational distance_of(const Range& range, DepthForm form, const Rational& depth) {
  const Rational n = to_rational(double{range.near}), f = to_rational(double{range.far});
  const Rational distance = form == DepthForm::linear
                                ? Rational(2 * f * n / (f + n - depth * (f - n)))
                                : Rational((depth * (f - n) + f + n) / 2);
  return distance;
}

void check_straight(const Range& range, DepthForm form, const Edge& edge, const Rational& s,
                    DepthCheck& check) {
  const Rational distance = edge.distance_at(s);
  const Rational right = range.depth<Rational>(form, distance);
  const Rational drawn = edge.interpolated_depth(range, form, s);
  ++check.samples;
  check.violations += drawn != right;
  const Rational off_ndc = drawn - right;
  const Rational off_m = distance_of(range, form, drawn) - distance;
  check.deviation_ndc = std::max(check.deviation_ndc, std::abs(CGAL::to_double(off_ndc)));
  check.deviation_m = std::max(check.deviation_m, std::abs(CGAL::to_double(off_m)));
}

void check_nearer_wins(const Range& range, DepthForm form, const Edge& a, const Edge& b,
                       const Rational& s, const Rational& t, DepthCheck& check) {
  const Rational distance_a = a.distance_at(s), distance_b = b.distance_at(t);
  if (distance_a == distance_b) return;
  const Rational depth_a = a.interpolated_depth(range, form, s);
  const Rational depth_b = b.interpolated_depth(range, form, t);
  ++check.samples;
  if ((distance_a < distance_b) == (depth_a < depth_b) && depth_a != depth_b) return;
  ++check.violations;
  const Rational gap = distance_a - distance_b;
  check.deviation_m = std::max(check.deviation_m, std::abs(CGAL::to_double(gap)));
}

Rational random_parameter(Random& random) { return to_rational(random.uniform()); }

void check_form(const Range& range, DepthForm form, std::size_t samples, Random& random,
                std::vector<DepthCheck>& checks) {
  const std::string_view name = form == DepthForm::linear ? "linear" : "quadratic";
  DepthCheck exact_order{name, "monotone", "exact"}, float_order{name, "monotone", "float"},
      double_order{name, "monotone", "double"}, straight{name, "lines stay straight", "exact"},
      wins{name, "nearer wins", "exact"};
  // The edge that goes all the way, at the point where the deviation is largest, comes first.
  const double root = std::sqrt(double{range.far} / range.near);
  check_straight(range, form, {to_rational(double{range.near}), to_rational(double{range.far})},
                 to_rational(root / (1 + root)), straight);
  for (std::size_t i = 0; i < samples; ++i) {
    const float nearer = std::min(range.random_distance(random), std::nextafter(range.far, 0.0f));
    const float farther = std::nextafter(nearer, std::numeric_limits<float>::infinity());
    check_order<Rational>(range, form, nearer, farther, true, exact_order);
    check_order<float>(range, form, nearer, farther, false, float_order);
    check_order<double>(range, form, nearer, farther, false, double_order);
    const Edge a = random_edge(range, random), b = random_edge(range, random);
    const Rational s = random_parameter(random), t = random_parameter(random);
    check_straight(range, form, a, s, straight);
    check_nearer_wins(range, form, a, b, s, t, wins);
  }
  for (const DepthCheck& check : {exact_order, float_order, double_order, straight, wins}) {
    checks.push_back(check);
  }
}

template <class T>
EyePlanePoint computed(const Projection<T>& projection) {
  const Vec4<T> p = to_clip(projection, Vec3<T>(T(1), T(1), T(0)));
  const Vec4<T> ndc = to_ndc(p);
  return {ScalarTraits<T>::name, nearest_double(p[0]),
          nearest_double(p[1]),  nearest_double(p[2]),
          nearest_double(p[3]),  is_finite(ndc[0]) && is_finite(ndc[1]) && is_finite(ndc[2])};
}

}  // namespace

std::vector<DepthCheck> check_depth_forms(float near, float far, std::size_t samples,
                                          Random& random) {
  std::vector<DepthCheck> checks;
  for (const DepthForm form : {DepthForm::linear, DepthForm::quadratic}) {
    check_form({near, far}, form, samples, random, checks);
  }
  return checks;
}

double largest_line_deviation(double far_near_ratio) {
  const double root = std::sqrt(far_near_ratio);
  return 2 * (root - 1) / (root + 1);
}

std::vector<EyePlanePoint> point_beside_the_eye() {
  const Frustum<double> frustum{
      .left = -1, .right = 1, .bottom = -1, .top = 1, .near = 1, .far = 10};
  reference::InputVertex point;
  point.position = {1, 1, 0, 1};
  const auto clip = reference::Truth::of_frustum(frustum).clip_position(point);
  EyePlanePoint exact{"exact",
                      CGAL::to_double(clip[0]),
                      CGAL::to_double(clip[1]),
                      CGAL::to_double(clip[2]),
                      CGAL::to_double(clip[3]),
                      clip[3] != 0};
  return {exact, computed(projection_from<float>(frustum)),
          computed(projection_from<double>(frustum))};
}

}  // namespace clipscope::experiments

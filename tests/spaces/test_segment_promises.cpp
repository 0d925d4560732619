// SPDX-License-Identifier: GPL-3.0-or-later
//
// The error bounds that segment clippers promise (spaces/clipper.hpp), measured.
//
// As in experiments/judge/promise.hpp everything is measured in clip space, where a vertex (x, y,
// z, 1/w) of the answer is the point (x, y, z, 1) w: how far it is outside the volume, how far from
// the input segment, and how far from it what is visible of the exact segment in the volume made
// smaller by the bound. Numbers are double-double for float and double, rationals for exact
// arithmetic.
#include <cmath>

#include "tests/catch.hpp"
#include "tests/spaces/clippers.hpp"
#include "tests/spaces/segments.hpp"

using namespace clipscope;
using namespace clipscope::tests;
using experiments::Exact;
using experiments::nearest_double;

namespace {

using N = dd_real;
using Point = std::array<N, 4>;
using Segment = std::array<Point, 2>;

N number(float x) { return N(x); }
N number(double x) { return N(x); }
N number(const N& x) { return x; }

template <class Position>
Point lift(const Position& p) {
  return {number(p[0]), number(p[1]), number(p[2]), number(p[3])};
}

template <class T>
Point lift_ndc(const NdcVertex<T, K>& v) {
  const N w = N(1) / number(v.position[3]);
  return {number(v.position[0]) * w, number(v.position[1]) * w, number(v.position[2]) * w, w};
}

Point point_at(const Segment& s, const N& t) {
  Point r;
  for (std::size_t i = 0; i < 4; ++i) r[i] = s[0][i] + t * (s[1][i] - s[0][i]);
  return r;
}

N distance_to_segment(const Point& p, const Segment& s) {
  N along(0), length(0);
  for (std::size_t i = 0; i < 4; ++i) {
    along = along + (p[i] - s[0][i]) * (s[1][i] - s[0][i]);
    length = length + (s[1][i] - s[0][i]) * (s[1][i] - s[0][i]);
  }
  N t = length == N(0) ? N(0) : along / length;
  if (t < N(0)) t = N(0);
  if (N(1) < t) t = N(1);
  const Point nearest = point_at(s, t);
  N squared(0);
  for (std::size_t i = 0; i < 4; ++i) squared = squared + (p[i] - nearest[i]) * (p[i] - nearest[i]);
  return sqrt(squared);
}

N plane_distance(Plane plane, const Point& p) {
  return clip_distance(DepthRange::minus_one_to_one, plane, Vec4<N>(p[0], p[1], p[2], p[3]));
}

std::optional<Interval<N>> visible_part(const Segment& s, Outcode planes, double margin) {
  return visible_interval<N>(planes, N(margin), [&](Plane plane) {
    return std::array<N, 2>{plane_distance(plane, s[0]), plane_distance(plane, s[1])};
  });
}

// w_max / w_min of what is left after the near cut; 0 where the promise does not speak of the
// segment.
double amplification(const Promise& promise, const Segment& s) {
  if (promise.domain == Promise::Domain::any) return 1;
  Interval<N> part;
  if (promise.domain == Promise::Domain::divisible) {
    const auto front = visible_part(s, bit(Plane::near), 0);
    if (!front) return 1;
    part = *front;
  }
  const double a = nearest_double(point_at(s, part.from)[3]);
  const double b = nearest_double(point_at(s, part.to)[3]);
  if (!(a > 0 && b > 0)) return 0;
  return std::max(a, b) / std::min(a, b);
}

// The largest of the three distances.
template <class T>
double error(const Segment& input, const NdcPolygon<T, K>& out, double bound) {
  double worst = 0;
  const auto note = [&](const N& d) { worst = std::max(worst, nearest_double(d)); };
  Segment found;
  for (int v = 0; v < out.size(); ++v) {
    found[static_cast<std::size_t>(v)] = lift_ndc(out[v]);
    const Point& p = found[static_cast<std::size_t>(v)];
    for (const Plane plane : kAllPlanes) note(N(-plane_distance(plane, p)));
    note(distance_to_segment(p, input));
  }
  const auto covered = visible_part(input, planes_of(ClipVolume{}), bound);
  if (covered) {
    if (out.empty()) return HUGE_VAL;
    note(distance_to_segment(point_at(input, covered->from), found));
    note(distance_to_segment(point_at(input, covered->to), found));
  }
  return worst;
}

// The largest error met, in units of u M amplification, over random segments of many shapes.
template <class T>
double worst_ulps(const ClipperIn<T, 2>& clip, std::mt19937_64& random, int count) {
  double worst = 0;
  for (int n = 0; n < count; ++n) {
    Ends ends = random_ends(random, std::ldexp(1.0, n % 12 - 2));
    if (n % 3 == 0) {  // long, and grazing a corner
      for (std::size_t i = 0; i < 2; ++i) {
        ends[1][i] = static_cast<float>(2 - ends[0][i]);
        ends[0][3] = ends[1][3] = 1;
      }
    }
    if (clip.promise.domain == Promise::Domain::in_front || n % 4 == 0) {
      for (auto& end : ends) end[3] = std::abs(end[3]) + 0x1p-10;
    }
    const auto segment = clip_segment<T>(ends);
    const Segment input = {lift(segment[0].position), lift(segment[1].position)};
    const double ratio = amplification(clip.promise, input);
    if (ratio == 0) continue;
    double largest = 0;
    for (const auto& end : ends) {
      for (const double x : end) largest = std::max(largest, std::abs(x));
    }
    const double unit = experiments::kFormat<T>.unit_roundoff() * largest * ratio;
    const double found = error(input, clip(segment), clip.promise.ulps * unit) / unit;
    INFO(clip.name << ", segment " << n << ": " << found << " ulps");
    CHECK(found <= clip.promise.ulps);
    worst = std::max(worst, found);
  }
  return worst;
}

}  // namespace

TEST_CASE(
    "segment promises: no error is beyond the bound, and some rounding is there to be bound") {
  std::mt19937_64 random(41);
  const auto is_bounded = [](const auto& clip) {
    return clip.takes_clip_space() && clip.promise.ulps != kUnbounded;
  };
  for (const auto& clip : clippers<float, 2>()) {
    if (is_bounded(clip)) CHECK(worst_ulps(clip, random, 3000) > 0.5);
  }
  for (const auto& clip : clippers<double, 2>()) {
    if (is_bounded(clip)) CHECK(worst_ulps(clip, random, 1500) > 0.5);
  }
}

TEMPLATE_TEST_CASE("segment promises: Cyrus-Beck keeps its bound in view space", "", ViewCyrusBeck,
                   ViewCyrusBeckUnitNormals) {
  std::mt19937_64 random(42);
  const Frustum<double> frustum{.left = -0.5, .right = 1, .near = 0.5, .far = 20};
  const Projection<N> exact(frustum_cast<N>(frustum));
  const Projection<float> projection(frustum_cast<float>(frustum));
  for (int n = 0; n < 3000; ++n) {
    const Ends ends = random_ends(random, std::ldexp(1.0, n % 8));
    Segment input;
    double largest = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      input[i] = lift(to_clip(exact, Vec3<N>(N(ends[i][0]), N(ends[i][1]), N(ends[i][2]))));
      // The terms of the clip coordinates: x.own = 4 / 6, y.own = 1, |x.z| = 1 / 3, z.one about
      // 1.03.
      for (const double x : ends[i]) largest = std::max(largest, 2 * std::abs(x) + 1.1);
    }
    const double unit = experiments::kFormat<float>.unit_roundoff() * largest;
    NdcPolygon<float, K> out;
    TestType{}(projection, view_segment<float>(ends), out);
    const double found = error(input, out, TestType::promise.ulps * unit) / unit;
    CHECK(found <= TestType::promise.ulps);
  }
}

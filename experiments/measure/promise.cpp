// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/measure/promise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include "experiments/measure/distance.hpp"
#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {
namespace {

using reference::ExactPolygon;
using reference::ExactVertex;
using reference::InputTriangle;

// The number type that distances are computed in.
template <class T>
using DistanceNumber =
    std::conditional_t<(ScalarTraits<T>::precision > 0 && ScalarTraits<T>::precision <= 53),
                       dd_real, Exact>;

template <class N>
N number(const Exact& x) {
  if constexpr (std::same_as<N, Exact>) {
    return x;
  } else {
    const double high = CGAL::to_double(x);
    const Exact rest = x - Exact(high);
    return dd_real(high) + dd_real(CGAL::to_double(rest));
  }
}

// Signed distances of a lifted point to the planes of the volume; the smallest.
template <class N>
N least_plane_distance(DepthRange depth, const Lifted<N>& p) {
  const N& w = p[3];
  N least = w - p[0];
  const N low_z = depth == DepthRange::minus_one_to_one ? N(w + p[2]) : p[2];
  for (const N& d : {N(w + p[0]), N(w - p[1]), N(w + p[1]), N(w - p[2]), low_z}) {
    if (d < least) least = d;
  }
  return least;
}

// Everything that one check works on.
template <class T, int K>
struct Case {
  using N = DistanceNumber<T>;
  std::vector<Lifted<N>> input;    // the triangle
  std::vector<Lifted<N>> polygon;  // the clipper's answer
  double unit = 0;                 // u M amplification
  double tolerance = 0;
  Exact attribute_scale = Exact(0);
  int attribute_count = 0;  // those that the promise speaks of
};

template <class T, int K>
Lifted<DistanceNumber<T>> lift(const NdcVertex<T, K>& v, const Case<T, K>& c) {
  using N = DistanceNumber<T>;
  Lifted<N> p;
  const N w = N(1) / number<N>(to_exact(v.position[3]));
  for (int i = 0; i < 3; ++i) {
    p.push_back(N(number<N>(to_exact(v.position[i])) * w));
  }
  p.push_back(w);
  for (int k = 0; k < c.attribute_count; ++k) {
    p.push_back(number<N>(Exact(to_exact(v.attributes[k]) * c.attribute_scale)));
  }
  return p;
}

template <class N>
Lifted<N> lift_exact(const ExactVertex& v, const Exact& attribute_scale, int attribute_count) {
  Lifted<N> p;
  const Exact inv_w = reference::to_rational(v.inv_w);
  const Exact w = Exact(1) / inv_w;
  for (const reference::Fraction* x : {&v.x, &v.y, &v.z}) {
    p.push_back(number<N>(Exact(reference::to_rational(*x) * w)));
  }
  p.push_back(number<N>(w));
  for (int k = 0; k < attribute_count; ++k) {
    const Exact a = reference::to_rational(v.attributes[static_cast<std::size_t>(k)]);
    p.push_back(number<N>(Exact(a * attribute_scale)));
  }
  return p;
}

template <class T, int K>
bool is_liftable(std::span<const NdcVertex<T, K>> polygon) {
  return std::all_of(polygon.begin(), polygon.end(), [](const NdcVertex<T, K>& v) {
    return is_finite(v) && !(v.position[3] == T(0));
  });
}

double largest_attribute(const InputTriangle& triangle) {
  double largest = 0;
  for (const auto& v : triangle.vertices) {
    for (int k = 0; k < triangle.attribute_count; ++k) {
      largest = std::max(largest, std::abs(v.attributes[static_cast<std::size_t>(k)]));
    }
  }
  return largest;
}

// Notes a squared distance; breaks the promise where it is beyond the tolerance.
template <class T, int K, class N>
void judge(const N& squared, const Case<T, K>& c, std::string_view what, PromiseCheck& check) {
  const N bound = N(c.tolerance) * N(c.tolerance);
  const double distance = std::sqrt(nearest_double(squared));
  if (c.unit > 0) {
    check.ulps = std::max(check.ulps, distance / c.unit);
  } else if (N(0) < squared) {
    check.ulps = std::numeric_limits<double>::infinity();
  }
  if (bound < squared && check.verdict == PromiseVerdict::kept) {
    check.verdict = PromiseVerdict::broken;
    check.reason =
        fmt::format("{}: {:.3g} in clip space, promised {:.3g}", what, distance, c.tolerance);
  }
}

template <class T, int K>
void judge_containment(DepthRange depth, const Case<T, K>& c, PromiseCheck& check) {
  using N = DistanceNumber<T>;
  for (const Lifted<N>& p : c.polygon) {
    const N least = least_plane_distance(depth, p);
    if (least < N(0)) judge(N(least * least), c, "a vertex lies outside the volume", check);
  }
}

template <class T, int K>
void judge_vertices(const Case<T, K>& c, PromiseCheck& check) {
  using N = DistanceNumber<T>;
  for (const Lifted<N>& p : c.polygon) {
    const N d = squared_distance_to_triangle(p, c.input[0], c.input[1], c.input[2]);
    judge(d, c, "a vertex lies off the triangle", check);
  }
}

// The clipper kept the triangle whole: its vertices must be the triangle's.
template <class T, int K>
void judge_whole(const Case<T, K>& c, PromiseCheck& check) {
  if (c.polygon.size() != 3) {
    check = {PromiseVerdict::broken, 0, fmt::format("{} vertices, promised 3", c.polygon.size())};
    return;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const auto d = difference(c.polygon[i], c.input[i]);
    judge(dot(d, d), c, "a vertex was moved", check);
  }
}

template <class T, int K>
void judge_coverage(const reference::Truth& truth, const InputTriangle& triangle,
                    const Case<T, K>& c, PromiseCheck& check) {
  using N = DistanceNumber<T>;
  const ExactPolygon deep = reference::clip(truth.inset(c.tolerance), triangle);
  if (deep.vertices.size() < 3) return;
  if (c.polygon.size() < 3) {
    check.verdict = PromiseVerdict::broken;
    check.ulps = std::numeric_limits<double>::infinity();
    check.reason = "nothing was drawn, but part of the triangle is visible";
    return;
  }
  for (const ExactVertex& v : deep.vertices) {
    const Lifted<N> p = lift_exact<N>(v, c.attribute_scale, c.attribute_count);
    judge(squared_distance_to_polygon(p, c.polygon), c, "a visible point was not drawn", check);
  }
}

// The triangle's vertices in clip space.
using RoundedCorners = std::array<std::array<double, 4>, 3>;

struct Corners {
  std::array<std::array<Exact, 4>, 3> exact;
  RoundedCorners rounded;
  bool divisible = true;  // no w is 0
};

Corners corners_of(const reference::Truth& truth, const InputTriangle& triangle) {
  Corners corners;
  for (std::size_t i = 0; i < 3; ++i) {
    corners.exact[i] = truth.clip_position(triangle.vertices[i]);
    std::transform(corners.exact[i].begin(), corners.exact[i].end(), corners.rounded[i].begin(),
                   [](const Exact& x) { return CGAL::to_double(x); });
    corners.divisible = corners.divisible && corners.exact[i][3] != Exact(0);
  }
  return corners;
}

// The range of w over the part of the triangle in front of the near plane.
struct WRange {
  double smallest = std::numeric_limits<double>::infinity();
  double largest = 0;
  bool in_front = true;  // all of the triangle is
};

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
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& a = corners[i];
    const auto& b = corners[(i + 1) % 3];
    const double d_a = near_distance(a), d_b = near_distance(b);
    if (d_a >= 0) {
      note(a[3]);
    } else {
      range.in_front = false;
    }
    if ((d_a < 0) != (d_b < 0)) note(a[3] + d_a / (d_a - d_b) * (b[3] - a[3]));
  }
  return range;
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

template <class T, int K>
Case<T, K> make_case(const Promise& promise, const InputTriangle& triangle, const Corners& corners,
                     const WRange& w, double magnitude, std::span<const NdcVertex<T, K>> polygon) {
  using N = DistanceNumber<T>;
  Case<T, K> c;
  c.unit = unit_roundoff<T>() * magnitude;
  if (promise.amplification == Promise::Amplification::w_ratio && w.largest > 0) {
    c.unit *= w.largest / w.smallest;
  }
  c.tolerance = promise.ulps * c.unit;
  c.attribute_count = promise.attributes ? triangle.attribute_count : 0;
  const double attribute = largest_attribute(triangle);
  c.attribute_scale = attribute > 0 ? Exact(magnitude / attribute) : Exact(0);
  for (std::size_t i = 0; i < 3; ++i) {
    Lifted<N>& p = c.input.emplace_back();
    for (const Exact& x : corners.exact[i]) p.push_back(number<N>(x));
    for (int k = 0; k < c.attribute_count; ++k) {
      const Exact a(triangle.vertices[i].attributes[static_cast<std::size_t>(k)]);
      p.push_back(number<N>(Exact(a * c.attribute_scale)));
    }
  }
  for (const NdcVertex<T, K>& v : polygon) c.polygon.push_back(lift(v, c));
  return c;
}

}  // namespace

PromiseChecker::PromiseChecker(const Frustum<double>& frustum)
    : truth_(reference::Truth::of_frustum(frustum)),
      projection_(frustum),
      depth_(frustum.depth),
      view_input_(true) {}

PromiseChecker::PromiseChecker(DepthRange depth)
    : truth_(reference::Truth::of_clip(depth)), depth_(depth), view_input_(false) {}

// M of one vertex: the largest sum of magnitudes of the terms that make up a clip coordinate.
double PromiseChecker::coordinate_magnitude(const reference::InputVertex& vertex) const {
  const auto& p = vertex.position;
  if (!view_input_) {
    return std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2]), std::abs(p[3])});
  }
  const auto terms = [&](const ProjectionRow<double>& row, double own) {
    return std::abs(row.own * own) + std::abs(row.z * p[2]) + std::abs(row.one);
  };
  return std::max({terms(projection_.x, p[0]), terms(projection_.y, p[1]),
                   terms(projection_.z, 0.0), terms(projection_.w, 0.0)});
}

template <class T, int K>
PromiseCheck PromiseChecker::check(const Promise& promise, const InputTriangle& triangle,
                                   std::span<const NdcVertex<T, K>> polygon) const {
  const Corners corners = corners_of(truth_, triangle);
  const WRange w = w_in_front(depth_, corners.rounded);
  if (!is_in_domain(promise.domain, w, corners.divisible)) {
    return {PromiseVerdict::outside_domain, 0, ""};
  }
  if (!is_liftable(polygon)) {
    return {PromiseVerdict::broken, std::numeric_limits<double>::infinity(),
            "a coordinate of the result is not finite, or 1/w is 0"};
  }
  double magnitude = 0;
  for (const reference::InputVertex& v : triangle.vertices) {
    magnitude = std::max(magnitude, coordinate_magnitude(v));
  }
  const Case<T, K> c = make_case(promise, triangle, corners, w, magnitude, polygon);
  PromiseCheck check;
  if (promise.contained) judge_containment(depth_, c, check);
  if (promise.domain != Promise::Domain::all_or_nothing) {
    judge_vertices(c, check);
  } else if (!polygon.empty()) {
    judge_whole(c, check);
  }
  if (promise.covers) judge_coverage(truth_, triangle, c, check);
  return check;
}

template <class T>
using SceneSpan = std::span<const NdcVertex<T, kSceneAttributes>>;
template PromiseCheck PromiseChecker::check(const Promise&, const InputTriangle&,
                                            SceneSpan<float>) const;
template PromiseCheck PromiseChecker::check(const Promise&, const InputTriangle&,
                                            SceneSpan<double>) const;
template PromiseCheck PromiseChecker::check(const Promise&, const InputTriangle&,
                                            SceneSpan<dd_real>) const;
template PromiseCheck PromiseChecker::check(const Promise&, const InputTriangle&,
                                            SceneSpan<Exact>) const;
template PromiseCheck PromiseChecker::check(const Promise&, const InputTriangle&,
                                            SceneSpan<Counted>) const;

}  // namespace clipscope::experiments

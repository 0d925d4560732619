// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/measure/promise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

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

// A point of clip space with attributes as further coordinates.
template <class N>
using Lifted = std::vector<N>;

template <class N>
Lifted<N> difference(const Lifted<N>& a, const Lifted<N>& b) {
  Lifted<N> d(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) d[i] = a[i] - b[i];
  return d;
}

template <class N>
N dot(const Lifted<N>& a, const Lifted<N>& b) {
  N sum(0);
  for (std::size_t i = 0; i < a.size(); ++i) sum = sum + N(a[i] * b[i]);
  return sum;
}

// Square of the distance from p to a + s ab + t ac.
template <class N>
N squared_distance(const Lifted<N>& ap, const Lifted<N>& ab, const Lifted<N>& ac, const N& s,
                   const N& t) {
  N sum(0);
  for (std::size_t i = 0; i < ap.size(); ++i) {
    const N d = ap[i] - s * ab[i] - t * ac[i];
    sum = sum + N(d * d);
  }
  return sum;
}

// The parameter in [0, 1] of the point of a segment nearest to p; `along` is its direction.
template <class N>
N nearest_on_segment(const Lifted<N>& start_to_p, const Lifted<N>& along) {
  const N length = dot(along, along);
  const N projected = dot(start_to_p, along);
  if (projected <= N(0) || length <= N(0)) return N(0);
  if (length <= projected) return N(1);
  return N(projected / length);
}

// Square of the distance from p to the triangle a b c, which may be degenerate.
template <class N>
N squared_distance_to_triangle(const Lifted<N>& p, const Lifted<N>& a, const Lifted<N>& b,
                               const Lifted<N>& c) {
  const Lifted<N> ab = difference(b, a), ac = difference(c, a), ap = difference(p, a);
  const N g11 = dot(ab, ab), g12 = dot(ab, ac), g22 = dot(ac, ac);
  const N h1 = dot(ap, ab), h2 = dot(ap, ac);
  const N determinant = g11 * g22 - g12 * g12;
  const N s = g22 * h1 - g12 * h2;
  const N t = g11 * h2 - g12 * h1;
  const N rest = determinant - s - t;
  if (N(0) < determinant && N(0) <= s && N(0) <= t && N(0) <= rest) {
    return squared_distance(ap, ab, ac, N(s / determinant), N(t / determinant));
  }
  const N on_ab = nearest_on_segment(ap, ab);
  const N on_ac = nearest_on_segment(ap, ac);
  const N on_bc = nearest_on_segment(difference(p, b), difference(c, b));
  const N d_ab = squared_distance(ap, ab, ac, on_ab, N(0));
  const N d_ac = squared_distance(ap, ab, ac, N(0), on_ac);
  const N d_bc = squared_distance(ap, ab, ac, N(N(1) - on_bc), on_bc);
  return std::min({d_ab, d_ac, d_bc});
}

// Square of the distance from p to the convex polygon, as a fan.
template <class N>
N squared_distance_to_polygon(const Lifted<N>& p, const std::vector<Lifted<N>>& polygon) {
  N best = squared_distance_to_triangle(p, polygon[0], polygon[1], polygon[2]);
  for (std::size_t i = 3; i < polygon.size(); ++i) {
    const N d = squared_distance_to_triangle(p, polygon[0], polygon[i - 1], polygon[i]);
    if (d < best) best = d;
  }
  return best;
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
    for (int i = 0; i < 4; ++i) {
      if (!is_finite(v.position[i])) return false;
    }
    for (int k = 0; k < v.attributes.size(); ++k) {
      if (!is_finite(v.attributes[k])) return false;
    }
    return !(v.position[3] == T(0));
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

// The range of w over the part of the triangle in front of the near plane.
struct WRange {
  double smallest = std::numeric_limits<double>::infinity();
  double largest = 0;
  bool in_front = true;  // all of the triangle is
};

using ClipCorners = std::array<std::array<double, 4>, 3>;

WRange w_in_front(DepthRange depth, const ClipCorners& corners) {
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
  using N = DistanceNumber<T>;
  std::array<std::array<Exact, 4>, 3> corners;
  ClipCorners rounded;
  double magnitude = 0;
  bool divisible = true;
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i] = truth_.clip_position(triangle.vertices[i]);
    std::transform(corners[i].begin(), corners[i].end(), rounded[i].begin(),
                   [](const Exact& x) { return CGAL::to_double(x); });
    magnitude = std::max(magnitude, coordinate_magnitude(triangle.vertices[i]));
    divisible = divisible && corners[i][3] != Exact(0);
  }
  const WRange w = w_in_front(depth_, rounded);
  PromiseCheck check;
  if (!is_in_domain(promise.domain, w, divisible)) {
    check.verdict = PromiseVerdict::outside_domain;
    return check;
  }
  if (!is_liftable(polygon)) {
    return {PromiseVerdict::broken, std::numeric_limits<double>::infinity(),
            "a coordinate of the result is not finite, or 1/w is 0"};
  }

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
    for (const Exact& x : corners[i]) p.push_back(number<N>(x));
    for (int k = 0; k < c.attribute_count; ++k) {
      const Exact a(triangle.vertices[i].attributes[static_cast<std::size_t>(k)]);
      p.push_back(number<N>(Exact(a * c.attribute_scale)));
    }
  }
  for (const NdcVertex<T, K>& v : polygon) c.polygon.push_back(lift(v, c));

  if (promise.contained) judge_containment(depth_, c, check);
  if (promise.domain == Promise::Domain::all_or_nothing) {
    if (!polygon.empty()) judge_whole(c, check);
  } else {
    judge_vertices(c, check);
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

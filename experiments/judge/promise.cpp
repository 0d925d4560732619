// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/promise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "experiments/judge/compare.hpp"
#include "experiments/judge/containment.hpp"
#include "experiments/judge/cycle.hpp"
#include "experiments/judge/distance.hpp"

namespace clipscope::experiments {

// The primitive's vertices in clip space.
using RoundedCorners = std::vector<std::array<double, 4>>;

struct Corners {
  std::vector<std::array<Exact, 4>> exact;
  RoundedCorners rounded;
  bool divisible = true;  // no w is 0
};

// The range of w over the part of the primitive in front of the near plane.
struct WRange {
  double smallest = std::numeric_limits<double>::infinity();
  double largest = 0;
  bool in_front = true;  // all of the primitive is
};

// What a check works on before any distance is computed. magnitude: M; unit: of the promise.
struct PromiseChecker::Setting {
  std::span<const reference::InputVertex> vertices;
  int attribute_count;
  Corners corners;
  WRange w = {};
  double magnitude = 0, unit = 0, tolerance = 0;
};

namespace {

using reference::ExactPolygon;
using reference::ExactVertex;
using reference::InputVertex;

using InputVertices = std::span<const InputVertex>;

// Signed distances of a lifted point to the planes of the volume; the smallest. Clip distances
// count as far as the point has attributes.
template <class N>
N least_plane_distance(const ClipVolume& volume, const Lifted<N>& p) {
  const N& w = p[3];
  N least = w - p[0];
  const auto note = [&](const N& d) {
    if (d < least) least = d;
  };
  for (const N& d : {N(w + p[0]), N(w - p[1]), N(w + p[1])}) note(d);
  const DepthBounds is_bounded(volume);
  if (is_bounded.high) note(N(w - p[2]));
  if (is_bounded.low) note(volume.depth == DepthRange::minus_one_to_one ? N(w + p[2]) : p[2]);
  const std::size_t planes = 4 + static_cast<std::size_t>(volume.clip_distances);
  for (std::size_t i = 4; i < std::min(planes, p.size()); ++i) note(p[i]);
  return least;
}

// Everything that one check works on; `polygon` is filled when it is known that it can be lifted.
template <class N>
struct Case {
  std::vector<Lifted<N>> input = {};    // the primitive, as a triangle
  std::vector<Lifted<N>> polygon = {};  // the clipper's answer, of a segment as a triangle
  double unit = 0;
  double tolerance = 0;
  Exact attribute_scale = Exact(0);
  int attribute_count = 0;  // those that the promise speaks of
  std::string_view noun = "triangle";
};

template <class N>
Lifted<N> lift(const VertexView& v, const Case<N>& c) {
  Lifted<N> p;
  const N w = N(1) / distance_number<N>(to_exact(v[3]));
  for (int i = 0; i < 3; ++i) p.push_back(N(distance_number<N>(to_exact(v.position(i))) * w));
  p.push_back(w);
  for (int k = 0; k < c.attribute_count; ++k) {
    p.push_back(distance_number<N>(Exact(to_exact(v.attribute(k)) * c.attribute_scale)));
  }
  return p;
}

// Fewer vertices than three are a triangle whose last vertex is there several times.
template <class N>
std::vector<Lifted<N>> as_triangle(std::vector<Lifted<N>> points) {
  while (!points.empty() && points.size() < 3) points.push_back(points.back());
  return points;
}

template <class N>
Lifted<N> lift_exact(const ExactVertex& v, const Exact& attribute_scale, int attribute_count) {
  Lifted<N> p;
  const Exact inv_w = reference::to_rational(v.inv_w);
  const Exact w = Exact(1) / inv_w;
  for (const reference::Fraction* x : {&v.x, &v.y, &v.z}) {
    p.push_back(distance_number<N>(Exact(reference::to_rational(*x) * w)));
  }
  p.push_back(distance_number<N>(w));
  for (int k = 0; k < attribute_count; ++k) {
    const Exact a = reference::to_rational(v.attributes[static_cast<std::size_t>(k)]);
    p.push_back(distance_number<N>(Exact(a * attribute_scale)));
  }
  return p;
}

// Whether all vertices are points of clip space: finite, and 1/w not 0.
bool is_liftable(const PolygonView& polygon) {
  return std::ranges::all_of(polygon, [](const VertexView& v) {
    for (std::size_t i = 0; i < v.size(); ++i) {
      if (!is_finite(v[i])) return false;
    }
    return v[3].value != 0;
  });
}

// Whether some 1/w is infinite and everything else is finite.
bool has_overflowed_inv_w(const PolygonView& polygon) {
  constexpr std::size_t kInverseW = 3;
  bool overflowed = false;
  for (const VertexView& v : polygon) {
    overflowed = overflowed || std::isinf(v[kInverseW].value);
    for (std::size_t i = 0; i < v.size(); ++i) {
      if (i != kInverseW && !is_finite(v[i])) return false;
    }
  }
  return overflowed;
}

double largest_attribute(InputVertices vertices, int attribute_count) {
  double largest = 0;
  for (const InputVertex& v : vertices) {
    for (int k = 0; k < attribute_count; ++k) {
      largest = std::max(largest, std::abs(v.attributes[static_cast<std::size_t>(k)]));
    }
  }
  return largest;
}

using Breach = PromiseCheck::Breach;
constexpr double kBeyondAll = std::numeric_limits<double>::infinity();

// Breaks the promise. kind: what of it.
void break_promise(PromiseCheck& check, Breach PromiseCheck::*kind, std::string reason,
                   double excess = kBeyondAll) {
  Breach& breach = check.*kind;
  breach.excess = std::max(breach.excess, excess);
  if (check.verdict == PromiseVerdict::kept) check.reason = reason;
  if (breach.reason.empty()) breach.reason = std::move(reason);
  check.verdict = PromiseVerdict::broken;
}

// Notes a squared distance; breaks the promise where it is beyond the tolerance.
template <class N>
void judge(const N& squared, const Case<N>& c, std::string_view what, PromiseCheck& check,
           Breach PromiseCheck::*kind) {
  const N bound = N(c.tolerance) * N(c.tolerance);
  const double distance = std::sqrt(nearest_double(squared));
  if (c.unit > 0) {
    check.ulps = std::max(check.ulps, distance / c.unit);
  } else if (N(0) < squared) {
    check.ulps = kBeyondAll;
  }
  if (!(bound < squared)) return;
  break_promise(
      check, kind,
      fmt::format("{}: {:.3g} in clip space, promised {:.3g}", what, distance, c.tolerance),
      c.tolerance > 0 ? distance / c.tolerance : kBeyondAll);
}

template <class N>
void judge_containment(const ClipVolume& volume, const Case<N>& c, PromiseCheck& check) {
  for (const Lifted<N>& p : c.polygon) {
    const N least = least_plane_distance(volume, p);
    if (!(least < N(0))) continue;
    judge(N(least * least), c, "a vertex lies outside the volume", check, &PromiseCheck::contained);
  }
}

// Nothing is to be drawn where no vertex is strictly inside of an open side moved outwards.
template <class N>
void judge_ownership(const reference::Truth& truth, const PromiseChecker::Setting& s,
                     const Case<N>& c, PromiseCheck& check) {
  if (!truth.volume().open_sides || c.polygon.empty()) return;
  const reference::Truth wider = truth.inset(-c.tolerance);
  for (const reference::Truth::HalfSpace& half_space : wider.half_spaces()) {
    const auto is_inside = [&](const InputVertex& v) { return sign(half_space.form, v) > 0; };
    if (!half_space.is_open || std::ranges::any_of(s.vertices, is_inside)) continue;
    check.ulps = kBeyondAll;
    break_promise(
        check, &PromiseCheck::contained,
        fmt::format("all of the {} is on or outside of an open side, and was drawn", c.noun));
  }
}

template <class N>
void judge_vertices(const Case<N>& c, PromiseCheck& check) {
  for (const Lifted<N>& p : c.polygon) {
    const N d = squared_distance_to_triangle(p, c.input[0], c.input[1], c.input[2]);
    judge(d, c, fmt::format("a vertex lies off the {}", c.noun), check, &PromiseCheck::contained);
  }
}

// The clipper kept the triangle whole: its vertices must be the triangle's.
template <class N>
void judge_whole(const Case<N>& c, PromiseCheck& check) {
  if (c.polygon.size() != 3) {
    break_promise(check, &PromiseCheck::covers,
                  fmt::format("{} vertices, promised 3", c.polygon.size()));
    return;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const auto d = difference(c.polygon[i], c.input[i]);
    judge(dot(d, d), c, "a vertex was moved", check, &PromiseCheck::covers);
  }
}

template <class N>
void judge_coverage(const reference::Truth& truth, const PromiseChecker::Setting& s,
                    const Case<N>& c, PromiseCheck& check) {
  const double attribute_tolerance =
      c.attribute_scale == Exact(0) ? 0 : c.tolerance / nearest_double(c.attribute_scale);
  const ExactPolygon deep =
      reference::clip(truth.inset(c.tolerance, attribute_tolerance), s.vertices, s.attribute_count);
  if (deep.vertices.size() < s.vertices.size()) return;
  if (c.polygon.empty()) {
    check.ulps = kBeyondAll;
    break_promise(check, &PromiseCheck::covers,
                  fmt::format("nothing was drawn, but part of the {} is visible", c.noun));
    return;
  }
  for (const ExactVertex& v : deep.vertices) {
    const Lifted<N> p = lift_exact<N>(v, c.attribute_scale, c.attribute_count);
    judge(squared_distance_to_polygon(p, c.polygon), c, "a visible point was not drawn", check,
          &PromiseCheck::covers);
  }
}

// By a product and three sums, see the header.
constexpr double kMatrixUlps = 4;

constexpr MatrixRows<double> kIdentityRows = {Vec4<double>(1, 0, 0, 0), Vec4<double>(0, 1, 0, 0),
                                              Vec4<double>(0, 0, 1, 0), Vec4<double>(0, 0, 0, 1)};

Corners corners_of(const reference::Truth& truth, InputVertices vertices) {
  Corners corners;
  for (const InputVertex& v : vertices) {
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

template <class N>
Case<N> make_case(const Promise& promise, const PromiseChecker::Setting& s) {
  Case<N> c{.unit = s.unit, .tolerance = s.tolerance};
  if (s.vertices.size() == 2) c.noun = "segment";
  c.attribute_count = promise.attributes ? s.attribute_count : 0;
  const double attribute = largest_attribute(s.vertices, s.attribute_count);
  c.attribute_scale = attribute > 0 ? Exact(Exact(s.magnitude) / Exact(attribute)) : Exact(0);
  for (std::size_t i = 0; i < s.vertices.size(); ++i) {
    Lifted<N>& p = c.input.emplace_back();
    for (const Exact& x : s.corners.exact[i]) p.push_back(distance_number<N>(x));
    for (int k = 0; k < c.attribute_count; ++k) {
      const Exact a(s.vertices[i].attributes[static_cast<std::size_t>(k)]);
      p.push_back(distance_number<N>(Exact(a * c.attribute_scale)));
    }
  }
  c.input = as_triangle(std::move(c.input));
  return c;
}

// Whether the answer of exact arithmetic is the exact polygon in every number: then all distances
// are 0, and none need be computed.
bool is_exact_polygon(const reference::Truth& truth, const PromiseChecker::Setting& s,
                      const PolygonView& polygon) {
  const ExactPolygon exact = reference::clip(truth, s.vertices, s.attribute_count);
  return same_cycle(polygon, exact.vertices, [&](const VertexView& v, const ExactVertex& e) {
    for (int i = 0; i < 4 + s.attribute_count; ++i) {
      if (to_exact(v[static_cast<std::size_t>(i)]) != reference::to_rational(coordinate(e, i))) {
        return false;
      }
    }
    return true;
  });
}

}  // namespace

PromiseChecker::PromiseChecker(reference::Truth truth, const MatrixRows<double>& rows,
                               const ClipVolume& volume)
    : truth_(std::move(truth)), rows_(rows), volume_(volume) {}

PromiseChecker::PromiseChecker(const Frustum<double>& frustum)
    : PromiseChecker(frustum, ClipVolume{.depth = frustum.depth}) {}

PromiseChecker::PromiseChecker(const Frustum<double>& f, const ClipVolume& volume)
    : PromiseChecker(reference::Truth::of_frustum(f, volume), rows_of(Projection<double>(f)),
                     volume) {
  longest_ = std::max({std::abs(f.left), std::abs(f.right), std::abs(f.bottom), std::abs(f.top),
                       std::abs(f.near), 1.0});
}

PromiseChecker::PromiseChecker(const ClipVolume& volume)
    : PromiseChecker(reference::Truth::of_clip(volume), kIdentityRows, volume) {}

PromiseChecker::PromiseChecker(const Batch& batch)
    : PromiseChecker(batch.space == Space::clip ? PromiseChecker(batch.volume)
                     : batch.matrix
                         ? PromiseChecker(reference::truth_of(batch), *batch.matrix, batch.volume)
                         : PromiseChecker(batch.frustum, batch.volume)) {
  by_matrix_ = batch.matrix.has_value();
}

// M of one vertex: the largest sum of magnitudes of the terms that make up a clip coordinate.
double PromiseChecker::coordinate_magnitude(const reference::InputVertex& vertex) const {
  double largest = 0;
  for (const Vec4<double>& row : rows_) {
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
      sum += std::abs(row[i] * vertex.position[static_cast<std::size_t>(i)]);
    }
    largest = std::max(largest, sum);
  }
  return largest;
}

// Bounds what the terms of plane distances in view space come to, in front of their sums.
double PromiseChecker::largest_intermediate(const reference::InputVertex& vertex) const {
  const auto& p = vertex.position;
  return std::max(coordinate_magnitude(vertex),
                  longest_ * std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])}));
}

// Whether the promise speaks of the primitive at all: its numbers stay in the format, and the
// tolerance leaves something to promise.
bool PromiseChecker::is_spoken_of(const Promise& promise, const Setting& s,
                                  const PolygonView& polygon) const {
  constexpr double kHeadroom = 8;  // sums of a few terms
  const double largest = polygon.format().largest();
  double intermediate = largest_attribute(s.vertices, s.attribute_count);
  for (const InputVertex& v : s.vertices) {
    intermediate = std::max(intermediate, largest_intermediate(v));
  }
  if (kHeadroom * intermediate > largest || has_overflowed_inv_w(polygon)) return false;
  if (!is_in_domain(promise.domain, s.w, s.corners.divisible)) return false;
  if (promise.domain == Promise::Domain::all_or_nothing) {
    return !overflows_divided(s.corners.rounded, largest);
  }
  const double smallest_w = smallest_visible_w(volume_, s.corners.rounded);
  return s.tolerance < s.magnitude && smallest_w > 2 * s.tolerance && smallest_w * largest > 1;
}

// The distances that the promise bounds, in numbers of type N.
template <class N>
PromiseCheck PromiseChecker::check_distances(const Promise& promise, const Setting& s,
                                             const PolygonView& polygon) const {
  Case<N> c = make_case<N>(promise, s);
  for (const VertexView& v : polygon) c.polygon.push_back(lift(v, c));
  PromiseCheck check;
  if (promise.contained) judge_containment(volume_, c, check);
  if (promise.contained) judge_ownership(truth_, s, c, check);
  if (promise.domain != Promise::Domain::all_or_nothing) {
    judge_vertices(c, check);
  } else if (!polygon.empty()) {
    judge_whole(c, check);
  }
  c.polygon = as_triangle(std::move(c.polygon));
  if (promise.covers) judge_coverage(truth_, s, c, check);
  return check;
}

PromiseCheck PromiseChecker::check(const Promise& promise, InputVertices vertices,
                                   int attribute_count, const PolygonView& polygon) const {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  if (const Failure* failure = polygon.failure()) {
    return {PromiseVerdict::broken, kInfinite, failure->reason};
  }
  if (std::isinf(promise.ulps) && !promise.covers && !promise.contained) return {};
  if (promise.correctly_rounded && !by_matrix_ && polygon.format().is_float()) {
    const std::string reason = misrounded(truth_, vertices, attribute_count, polygon);
    if (!reason.empty()) return {PromiseVerdict::broken, kInfinite, reason};
  }
  if (!polygon.empty() && vertices.size() < 3 && polygon.size() != vertices.size()) {
    return {PromiseVerdict::broken, 0,
            fmt::format("{} vertices, promised {}", polygon.size(), vertices.size())};
  }
  const Format& format = polygon.format();
  Setting s{.vertices = vertices,
            .attribute_count = attribute_count,
            .corners = corners_of(truth_, vertices)};
  s.w = w_in_front(volume_.depth, s.corners.rounded);
  for (const InputVertex& v : vertices) {
    s.magnitude = std::max(s.magnitude, coordinate_magnitude(v));
  }
  s.unit = format.unit_roundoff() * s.magnitude + format.smallest();
  if (promise.amplification == Promise::Amplification::w_ratio && s.w.largest > 0) {
    s.unit *= s.w.largest / s.w.smallest;
  }
  // Exact arithmetic is promised the exact answer by whoever knows no bound, too.
  if (s.unit > 0) s.tolerance = (promise.ulps + (by_matrix_ ? kMatrixUlps : 0)) * s.unit;
  if (!is_spoken_of(promise, s, polygon)) return {PromiseVerdict::outside_domain, 0, ""};
  if (!is_liftable(polygon)) {
    return {PromiseVerdict::broken, kInfinite,
            "a coordinate of the result is not finite, or 1/w is 0"};
  }
  return check_in_cheapest(promise, s, polygon);
}

// In the coarsest numbers that are fine enough. What is found to be broken is computed again in
// exact rationals, which have the last word.
PromiseCheck PromiseChecker::check_in_cheapest(const Promise& promise, const Setting& s,
                                               const PolygonView& polygon) const {
  const Format& format = polygon.format();
  PromiseCheck rough;
  rough.verdict = PromiseVerdict::broken;
  if (format.is_exact()) {
    const bool as_is = promise.domain != Promise::Domain::all_or_nothing;
    if (as_is && is_exact_polygon(truth_, s, polygon)) return {};
  } else if (format.precision <= kFormat<double>.precision) {
    rough = check_distances<dd_real>(promise, s, polygon);
  } else if (fits_quad_double(s.magnitude)) {
    rough = check_distances<qd_real>(promise, s, polygon);
  }
  if (rough.verdict == PromiseVerdict::kept) return rough;
  return check_distances<Exact>(promise, s, polygon);
}

}  // namespace clipscope::experiments

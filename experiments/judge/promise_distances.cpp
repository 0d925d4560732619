// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/promise_distances.hpp"

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
void judge_ownership(const reference::Truth& truth, const PromiseSetting& s, const Case<N>& c,
                     PromiseCheck& check) {
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
void judge_coverage(const reference::Truth& truth, const PromiseSetting& s, const Case<N>& c,
                    PromiseCheck& check) {
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

template <class N>
Case<N> make_case(const Promise& promise, const PromiseSetting& s) {
  Case<N> c{.unit = s.unit, .tolerance = s.tolerance};
  if (s.vertices.size() == 2) c.noun = "segment";
  c.attribute_count = promise.attributes ? s.attribute_count : 0;
  c.attribute_scale = s.attribute_scale;
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
bool is_exact_polygon(const reference::Truth& truth, const PromiseSetting& s,
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

// The distances that the promise bounds, in numbers of type N.
template <class N>
PromiseCheck check_in(const Promise& promise, const reference::Truth& truth,
                      const ClipVolume& volume, const PromiseSetting& s,
                      const PolygonView& polygon) {
  Case<N> c = make_case<N>(promise, s);
  for (const VertexView& v : polygon) c.polygon.push_back(lift(v, c));
  PromiseCheck check;
  if (promise.contained) judge_containment(volume, c, check);
  if (promise.contained) judge_ownership(truth, s, c, check);
  if (promise.domain != Promise::Domain::all_or_nothing) {
    judge_vertices(c, check);
  } else if (!polygon.empty()) {
    judge_whole(c, check);
  }
  c.polygon = as_triangle(std::move(c.polygon));
  if (promise.covers) judge_coverage(truth, s, c, check);
  return check;
}

}  // namespace

bool is_liftable(const PolygonView& polygon) {
  return std::ranges::all_of(polygon, [](const VertexView& v) {
    for (std::size_t i = 0; i < v.size(); ++i) {
      if (!is_finite(v[i])) return false;
    }
    return v[3].value != 0;
  });
}

// In the coarsest numbers that are fine enough. What is found to be broken is computed again in
// exact rationals, which have the last word.
PromiseCheck check_distances(const Promise& promise, const reference::Truth& truth,
                             const ClipVolume& volume, const PromiseSetting& s,
                             const PolygonView& polygon) {
  const Format& format = polygon.format();
  PromiseCheck rough;
  rough.verdict = PromiseVerdict::broken;
  if (format.is_exact()) {
    const bool as_is = promise.domain != Promise::Domain::all_or_nothing;
    if (as_is && is_exact_polygon(truth, s, polygon)) return {};
  } else if (format.precision <= kFormat<double>.precision) {
    rough = check_in<dd_real>(promise, truth, volume, s, polygon);
  } else if (fits_quad_double(s.magnitude)) {
    rough = check_in<qd_real>(promise, truth, volume, s, polygon);
  }
  if (rough.verdict == PromiseVerdict::kept) return rough;
  return check_in<Exact>(promise, truth, volume, s, polygon);
}

}  // namespace clipscope::experiments

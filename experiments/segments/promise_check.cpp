// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/segments/promise_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "experiments/measure/distance.hpp"
#include "experiments/measure/distance_number.hpp"
#include "experiments/scenes/scene.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments {
namespace {

template <class N>
using Ends = std::array<Lifted<N>, 2>;

// All planes of the volume, d >= 0 inside.
template <class N>
std::array<N, kPlanes> plane_distances(DepthRange depth, const Lifted<N>& p) {
  const N& w = p[3];
  const bool gl = depth == DepthRange::minus_one_to_one;
  return {N(w + p[0]), N(w - p[0]), N(w + p[1]), N(w - p[1]), gl ? N(w + p[2]) : p[2], N(w - p[2])};
}

// In front of the near plane alone.
template <class N>
N near_distance(DepthRange depth, const Lifted<N>& p) {
  const auto d = plane_distances(depth, p);
  return depth == DepthRange::reversed ? d[5] : d[4];
}

template <class N>
Lifted<N> point_at(const Ends<N>& s, const N& t) {
  Lifted<N> p;
  for (std::size_t i = 0; i < s[0].size(); ++i) p.push_back(N(s[0][i] + t * (s[1][i] - s[0][i])));
  return p;
}

// Parameters from the first end.
template <class N>
struct Interval {
  N from = N(0), to = N(1);

  // Keeps what has d >= 0, d going from a to b.
  void keep(const N& a, const N& b) {
    if (a < N(0) && b < N(0)) to = N(-1);
    if (a < N(0) && !(b < N(0))) from = std::max(from, N(a / (a - b)));
    if (b < N(0) && !(a < N(0))) to = std::min(to, N(a / (a - b)));
  }
  bool is_empty() const { return !(from < to); }
};

// The part at least `margin` inside of every plane.
template <class N>
Interval<N> visible_part(DepthRange depth, const Ends<N>& s, const N& margin) {
  const auto a = plane_distances(depth, s[0]), b = plane_distances(depth, s[1]);
  Interval<N> part;
  for (std::size_t i = 0; i < a.size(); ++i) part.keep(N(a[i] - margin), N(b[i] - margin));
  return part;
}

template <class N>
N squared_distance_to_segment(const Lifted<N>& p, const Ends<N>& s) {
  const Lifted<N> along = difference(s[1], s[0]), from_start = difference(p, s[0]);
  const N t = nearest_on_segment(from_start, along);
  return squared_distance(from_start, along, along, t, N(0));
}

// What the check of one answer works on.
template <class N>
struct Work {
  DepthRange depth;
  Ends<N> input;
  double unit, tolerance;
  PromiseCheck check = {};

  void judge(const N& squared, std::string_view what) {
    const double distance = std::sqrt(nearest_double(squared));
    if (unit > 0) {
      check.ulps = std::max(check.ulps, distance / unit);
    } else if (N(0) < squared) {
      check.ulps = std::numeric_limits<double>::infinity();
    }
    const N bound = N(tolerance) * N(tolerance);
    if (bound < squared && check.verdict == PromiseVerdict::kept) {
      check.verdict = PromiseVerdict::broken;
      check.reason =
          fmt::format("{}: {:.3g} in clip space, promised {:.3g}", what, distance, tolerance);
    }
  }

  void judge_vertices(const Ends<N>& answer, bool contained) {
    for (const Lifted<N>& p : answer) {
      judge(squared_distance_to_segment(p, input), "a vertex lies off the segment");
      if (!contained) continue;
      for (const N& d : plane_distances(depth, p)) {
        if (d < N(0)) judge(N(d * d), "a vertex lies outside the volume");
      }
    }
  }

  void judge_coverage(const std::optional<Ends<N>>& answer) {
    const Interval<N> part = visible_part(depth, input, N(tolerance));
    if (part.is_empty()) return;
    if (!answer) {
      check = {PromiseVerdict::broken, std::numeric_limits<double>::infinity(),
               "nothing was drawn, but part of the segment is visible"};
      return;
    }
    for (const N& t : {part.from, part.to}) {
      judge(squared_distance_to_segment(point_at(input, t), *answer),
            "a visible point was not drawn");
    }
  }
};

// w_max / w_min of the part that the promise speaks of; 0 where it does not speak of the segment.
template <class N>
double amplification(const Promise& promise, DepthRange depth, const Ends<N>& input) {
  Interval<N> part;
  const N d_first = near_distance(depth, input[0]), d_second = near_distance(depth, input[1]);
  part.keep(d_first, d_second);
  if (promise.domain == Promise::Domain::in_front && (d_first < N(0) || d_second < N(0))) return 0;
  if (promise.domain == Promise::Domain::any || part.to < part.from) return 1;
  const double a = nearest_double(point_at(input, part.from)[3]);
  const double b = nearest_double(point_at(input, part.to)[3]);
  if (!(a > 0 && b > 0)) return 0;
  return promise.amplification == Promise::Amplification::none ? 1
                                                               : std::max(a, b) / std::min(a, b);
}

// Whether the visible part comes so near to the eye that no bound in clip space says anything about NDC.
template <class N>
bool is_at_the_eye(DepthRange depth, const Ends<N>& input, double tolerance) {
  const Interval<N> part = visible_part(depth, input, N(0));
  if (part.is_empty()) return false;
  const N a = point_at(input, part.from)[3], b = point_at(input, part.to)[3];
  return std::min(a, b) <= N(2 * tolerance);
}

// The factor that makes the largest attribute as large as M; 0 if all are 0.
double attribute_scale(std::span<const reference::InputVertex> ends, int count, double magnitude) {
  double largest = 0;
  for (const reference::InputVertex& end : ends) {
    for (int k = 0; k < count; ++k) {
      largest = std::max(largest, std::abs(end.attributes[static_cast<std::size_t>(k)]));
    }
  }
  return largest > 0 ? magnitude / largest : 0;
}

template <class N, class T, int K>
Lifted<N> lift(const NdcVertex<T, K>& v, int attributes, double scale) {
  const N w = N(1) / distance_number<N>(to_exact(v.position[3]));
  Lifted<N> p;
  for (int i = 0; i < 3; ++i) p.push_back(N(distance_number<N>(to_exact(v.position[i])) * w));
  p.push_back(w);
  for (int k = 0; k < attributes; ++k) {
    p.push_back(N(distance_number<N>(to_exact(v.attributes[k])) * N(scale)));
  }
  return p;
}

template <class N>
Lifted<N> lift(const reference::Truth& truth, const reference::InputVertex& v, int attributes,
               double scale) {
  Lifted<N> p;
  for (const Exact& x : truth.clip_position(v)) p.push_back(distance_number<N>(x));
  for (int k = 0; k < attributes; ++k) {
    p.push_back(N(N(v.attributes[static_cast<std::size_t>(k)]) * N(scale)));
  }
  return p;
}

}  // namespace

SegmentPromiseChecker::SegmentPromiseChecker(const Frustum<double>& frustum)
    : truth_(reference::Truth::of_frustum(frustum)), projection_(frustum) {}

// M: the largest sum of magnitudes of the terms that make up a clip coordinate.
double SegmentPromiseChecker::magnitude(const reference::InputVertex& end) const {
  const auto& p = end.position;
  const auto terms = [&](const ProjectionRow<double>& row, double own) {
    return std::abs(row.own * own) + std::abs(row.z * p[2]) + std::abs(row.one);
  };
  return std::max({terms(projection_.x, p[0]), terms(projection_.y, p[1]),
                   terms(projection_.z, 0.0), terms(projection_.w, 0.0)});
}

template <class T, int K>
PromiseCheck SegmentPromiseChecker::check(const Promise& promise,
                                          std::span<const reference::InputVertex> ends,
                                          int attribute_count,
                                          std::span<const NdcVertex<T, K>> answer) const {
  using N = DistanceNumber<T>;
  if (!answer.empty() && answer.size() != 2) {
    return {PromiseVerdict::broken, 0, fmt::format("{} vertices for a segment", answer.size())};
  }
  for (const NdcVertex<T, K>& v : answer) {
    if (!is_finite(v) || v.position[3] == T(0)) {
      return {PromiseVerdict::broken, 0, "a coordinate of the result is not finite, or 1/w is 0"};
    }
  }
  const int attributes = promise.attributes ? attribute_count : 0;
  const double m = std::max(magnitude(ends[0]), magnitude(ends[1]));
  const double scale = attribute_scale(ends, attributes, m);
  const Ends<N> input = {lift<N>(truth_, ends[0], attributes, scale),
                         lift<N>(truth_, ends[1], attributes, scale)};
  const DepthRange depth = truth_.volume().depth;
  const double ratio = amplification(promise, depth, input);
  if (ratio == 0) return {PromiseVerdict::outside_domain, 0, ""};

  const double unit = unit_roundoff<T>() * m * ratio;
  if (is_at_the_eye(depth, input, promise.ulps * unit)) {
    return {PromiseVerdict::outside_domain, 0, ""};
  }
  Work<N> work{depth, input, unit, promise.ulps * unit};
  std::optional<Ends<N>> found;
  if (!answer.empty()) {
    found = {lift<N>(answer[0], attributes, scale), lift<N>(answer[1], attributes, scale)};
    work.judge_vertices(*found, promise.contained);
  }
  if (promise.covers) work.judge_coverage(found);
  return work.check;
}

template <class T>
using NdcSpan = std::span<const NdcVertex<T, kSceneAttributes>>;
using InputEnds = std::span<const reference::InputVertex>;
template PromiseCheck SegmentPromiseChecker::check(const Promise&, InputEnds, int,
                                                   NdcSpan<float>) const;
template PromiseCheck SegmentPromiseChecker::check(const Promise&, InputEnds, int,
                                                   NdcSpan<double>) const;
template PromiseCheck SegmentPromiseChecker::check(const Promise&, InputEnds, int,
                                                   NdcSpan<dd_real>) const;
template PromiseCheck SegmentPromiseChecker::check(const Promise&, InputEnds, int,
                                                   NdcSpan<Exact>) const;
template PromiseCheck SegmentPromiseChecker::check(const Promise&, InputEnds, int,
                                                   NdcSpan<Counted>) const;

}  // namespace clipscope::experiments

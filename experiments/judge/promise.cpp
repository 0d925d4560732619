// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/promise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "experiments/judge/promise_distances.hpp"

namespace clipscope::experiments {
namespace {

using reference::InputVertex;

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

double largest_attribute(std::span<const InputVertex> vertices, int attribute_count) {
  double largest = 0;
  for (const InputVertex& v : vertices) {
    for (int k = 0; k < attribute_count; ++k) {
      largest = std::max(largest, std::abs(v.attributes[static_cast<std::size_t>(k)]));
    }
  }
  return largest;
}

// By a product and three sums, see the header.
constexpr double kMatrixUlps = 4;

constexpr MatrixRows<double> kIdentityRows = {Vec4<double>(1, 0, 0, 0), Vec4<double>(0, 1, 0, 0),
                                              Vec4<double>(0, 0, 1, 0), Vec4<double>(0, 0, 0, 1)};

}  // namespace

bool is_same_bound(const Promise& a, const Promise& b) {
  const auto bound = [](const Promise& p) {
    return std::tuple(p.domain, p.covers, p.contained, p.attributes, p.ulps, p.amplification,
                      p.correctly_rounded);
  };
  return bound(a) == bound(b);
}

PromiseChecker::PromiseChecker(reference::Truth truth, const MatrixRows<double>& rows,
                               const ClipVolume& volume)
    : truth_(std::move(truth)), rows_(rows), volume_(volume) {}

PromiseChecker::PromiseChecker(const Frustum<double>& frustum)
    : PromiseChecker(frustum, ClipVolume{.depth = frustum.depth}) {}

PromiseChecker::PromiseChecker(const Frustum<double>& f, const ClipVolume& volume)
    : PromiseChecker(reference::Truth::of_frustum(f, volume), rows_of(Projection<double>(f)),
                     volume) {
  range_ = FrustumRange(f);
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

PromiseSetting PromiseChecker::setting(const Promise& promise,
                                       std::span<const InputVertex> vertices, int attribute_count,
                                       const Format& format) const {
  PromiseSetting s{.vertices = vertices,
                   .attribute_count = attribute_count,
                   .corners = corners_of(truth_, vertices)};
  s.w = w_in_front(volume_.depth, s.corners.rounded);
  for (const InputVertex& v : vertices) {
    s.magnitude = std::max(s.magnitude, coordinate_magnitude(v));
  }
  s.largest_attribute = largest_attribute(vertices, attribute_count);
  s.attribute_scale = attribute_scale(promise, format, s);
  s.unit = format.unit_roundoff() * s.magnitude + format.smallest();
  if (promise.amplification == Promise::Amplification::w_ratio && s.w.largest > 0) {
    s.unit *= s.w.largest / s.w.smallest;
  }
  // Exact arithmetic is promised the exact answer by whoever knows no bound, too.
  if (s.unit > 0) s.tolerance = (promise.ulps + (by_matrix_ ? kMatrixUlps : 0)) * s.unit;
  return s;
}

// Whether the promise speaks of the primitive at all: its numbers stay in the format, and the
// tolerance leaves something to promise.
bool PromiseChecker::is_spoken_of(const Promise& promise, const PromiseSetting& s,
                                  const PolygonView& polygon) const {
  if (!range_.fits(polygon.format(), s.magnitude) || has_overflowed_inv_w(polygon)) return false;
  double intermediate = 0;
  for (const InputVertex& v : s.vertices) {
    intermediate = std::max(intermediate, largest_intermediate(v));
  }
  return speaks_of(promise, volume_, s, polygon.format(), intermediate);
}

PromiseCheck PromiseChecker::check(const Promise& promise, std::span<const InputVertex> vertices,
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
  const PromiseSetting s = setting(promise, vertices, attribute_count, polygon.format());
  if (!is_spoken_of(promise, s, polygon)) return {PromiseVerdict::outside_domain, 0, ""};
  if (!is_liftable(polygon)) {
    return {PromiseVerdict::broken, kInfinite,
            "a coordinate of the result is not finite, or 1/w is 0"};
  }
  return check_distances(promise, truth_, volume_, s, polygon);
}

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact_clip.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <concepts>
#include <tuple>
#include <utility>

#include "reference/convex.hpp"

namespace clipscope::reference {
namespace {

using HalfSpace = Truth::HalfSpace;

using Vertices = std::span<const InputVertex>;

// Weights is a value at each vertex of the input; also the weights of a point. Its size is fixed
// for points, segments and triangles, which need no allocation then.
template <std::size_t N>
using Fixed = std::array<Dyadic, N>;
using Any = std::vector<Dyadic>;

template <class Weights>
Weights zeros(std::size_t size) {
  Weights r{};
  if constexpr (std::same_as<Weights, Any>) r.resize(size);
  return r;
}

template <class Weights, class Function>
Weights at_vertices(Vertices vertices, const Function& function) {
  Weights r = zeros<Weights>(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) r[i] = function(vertices[i]);
  return r;
}

// The value at lambda times the sum of lambda.
template <class Weights>
Dyadic interpolate(const Weights& lambda, const Weights& values) {
  Dyadic sum = 0;
  for (std::size_t i = 0; i < lambda.size(); ++i) {
    if (!lambda[i].is_zero()) sum += lambda[i] * values[i];
  }
  return sum;
}

// The point where the edge from a to b meets the plane. Pre-condition: d_a > 0 > d_b, so that both
// weights are positive.
template <class Weights>
Weights meet(const Weights& a, const Dyadic& d_a, const Weights& b, const Dyadic& d_b) {
  Weights r = zeros<Weights>(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) r[i] = d_a * b[i] - d_b * a[i];
  return r;
}

// The part of the polygon with d >= 0, where d is given at the vertices of the input. Two vertices
// are a segment: they have one edge.
template <class Weights>
std::vector<Weights> cut(const std::vector<Weights>& polygon, const Weights& d) {
  const std::size_t n = polygon.size();
  std::vector<Dyadic> distance;
  distance.reserve(n);
  for (const Weights& vertex : polygon) distance.push_back(interpolate(vertex, d));
  std::vector<Weights> r;
  r.reserve(n + 1);
  for (std::size_t i = 0; i < n; ++i) {
    const int side = distance[i].sign();
    if (side >= 0) r.push_back(polygon[i]);
    if (i + 1 == n && n < 3) break;
    const std::size_t next = (i + 1) % n;
    const int next_side = distance[next].sign();
    if (side > 0 && next_side < 0) {
      r.push_back(meet(polygon[i], distance[i], polygon[next], distance[next]));
    } else if (side < 0 && next_side > 0) {
      r.push_back(meet(polygon[next], distance[next], polygon[i], distance[i]));
    }
  }
  return r;
}

// What `classify` says, and for each half-space whether some vertex is outside of it.
struct Sides {
  Verdict verdict = Verdict::accepted;
  std::vector<const HalfSpace*> crossed;
};

Sides sides_of(const Truth& truth, Vertices vertices) {
  Sides sides;
  for (const HalfSpace& half_space : truth.half_spaces()) {
    std::size_t outside = 0, on = 0;
    for (const InputVertex& vertex : vertices) {
      const int side = sign(half_space.form, vertex);
      outside += side < 0 ? 1 : 0;
      on += side == 0 ? 1 : 0;
    }
    const std::size_t beyond = half_space.is_open ? outside + on : outside;
    if (beyond == vertices.size()) return {Verdict::rejected, {}};
    if (outside > 0) sides.crossed.push_back(&half_space);
  }
  const bool in_front =
      std::ranges::all_of(vertices, [&](const InputVertex& v) { return sign(truth.w(), v) > 0; });
  if (!sides.crossed.empty() || !in_front) sides.verdict = Verdict::clipped;
  return sides;
}

// Projects points of one primitive, given by their weights, to NDC.
template <class Weights>
class Projector {
 public:
  Projector(const Truth& truth, Vertices vertices, int attribute_count) : truth_(truth) {
    for (int i = 0; i < 3; ++i) {
      position_[i] = at_vertices<Weights>(
          vertices, [&](const InputVertex& v) { return truth.projection()[i].value(v); });
    }
    w_ = at_vertices<Weights>(vertices, [&](const InputVertex& v) { return value(truth.w(), v); });
    attributes_.reserve(attribute_count);
    for (int k = 0; k < attribute_count; ++k) {
      attributes_.push_back(at_vertices<Weights>(
          vertices, [&](const InputVertex& v) { return Dyadic(v.attributes[k]); }));
    }
  }

  bool is_in_front(const Weights& lambda) const { return interpolate(lambda, w_).sign() > 0; }

  // Pre-condition: is_in_front(lambda).
  ExactVertex operator()(const Weights& lambda) const {
    const Dyadic w = interpolate(lambda, w_);
    Dyadic sum = 0;
    for (const Dyadic& weight : lambda) sum += weight;
    ExactVertex r{
        coordinate(0, lambda, w), coordinate(1, lambda, w), coordinate(2, lambda, w), {sum, w}, {}};
    r.attributes.reserve(attributes_.size());
    for (const Weights& attribute : attributes_) {
      r.attributes.push_back({interpolate(lambda, attribute), sum});
    }
    return r;
  }

 private:
  Fraction coordinate(int i, const Weights& lambda, const Dyadic& w) const {
    return {interpolate(lambda, position_[i]), truth_.projection()[i].scale * w};
  }

  const Truth& truth_;
  std::array<Weights, 3> position_;  // clip coordinates times the scales of their rows
  Weights w_;
  std::vector<Weights> attributes_;
};

bool coincide(const ExactVertex& a, const ExactVertex& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

auto members(const RationalVertex& v) { return std::tie(v.x, v.y, v.z, v.inv_w, v.attributes); }

// Whether the half-open volume has a point of the closed part: for each open side some corner of
// the part is strictly inside.
template <class Weights>
bool is_owned(const Truth& truth, Vertices vertices, const std::vector<Weights>& part) {
  return std::ranges::all_of(truth.half_spaces(), [&](const HalfSpace& half_space) {
    if (!half_space.is_open) return true;
    const auto distance = at_vertices<Weights>(
        vertices, [&](const InputVertex& v) { return value(half_space.form, v); });
    return std::ranges::any_of(
        part, [&](const Weights& lambda) { return interpolate(lambda, distance).sign() > 0; });
  });
}

// Pre-condition: sides.verdict is not `rejected`.
template <class Weights>
ExactPolygon clip_crossed(const Truth& truth, const Sides& sides, Vertices vertices,
                          int attribute_count) {
  std::vector<Weights> polygon(vertices.size(), zeros<Weights>(vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i) polygon[i][i] = 1;
  for (const HalfSpace* half_space : sides.crossed) {
    polygon = cut(polygon, at_vertices<Weights>(vertices, [&](const InputVertex& v) {
                    return value(half_space->form, v);
                  }));
  }
  ExactPolygon r;
  if (!is_owned(truth, vertices, polygon)) return r;
  const Projector<Weights> project(truth, vertices, attribute_count);
  for (const Weights& lambda : polygon) {
    if (!project.is_in_front(lambda)) continue;
    ExactVertex vertex = project(lambda);
    const bool seen =
        std::ranges::any_of(r.vertices, [&](const ExactVertex& v) { return coincide(v, vertex); });
    if (!seen) r.vertices.push_back(std::move(vertex));
  }
  if (!r.vertices.empty()) r.verdict = sides.verdict;
  return r;
}

[[maybe_unused]] bool meets_preconditions(const Truth& truth, Vertices vertices,
                                          int attribute_count) {
  return !vertices.empty() && is_finite(vertices, attribute_count) &&
         truth.volume().clip_distances <= attribute_count &&
         (vertices.size() <= 3 || is_planar_convex(vertices, attribute_count));
}

}  // namespace

bool operator==(const RationalVertex& a, const RationalVertex& b) {
  return members(a) == members(b);
}

bool operator<(const RationalVertex& a, const RationalVertex& b) { return members(a) < members(b); }

Verdict classify(const Truth& truth, std::span<const InputVertex> vertices,
                 [[maybe_unused]] int attribute_count) {
  assert(meets_preconditions(truth, vertices, attribute_count));
  return sides_of(truth, vertices).verdict;
}

Verdict classify(const Truth& truth, const InputTriangle& triangle) {
  return classify(truth, triangle.vertices, triangle.attribute_count);
}

ExactPolygon clip(const Truth& truth, std::span<const InputVertex> vertices, int attribute_count) {
  assert(meets_preconditions(truth, vertices, attribute_count));
  const Sides sides = sides_of(truth, vertices);
  if (sides.verdict == Verdict::rejected) return {};
  switch (vertices.size()) {
    case 1: return clip_crossed<Fixed<1>>(truth, sides, vertices, attribute_count);
    case 2: return clip_crossed<Fixed<2>>(truth, sides, vertices, attribute_count);
    case 3: return clip_crossed<Fixed<3>>(truth, sides, vertices, attribute_count);
    default: return clip_crossed<Any>(truth, sides, vertices, attribute_count);
  }
}

ExactPolygon clip(const Truth& truth, const InputTriangle& triangle) {
  return clip(truth, triangle.vertices, triangle.attribute_count);
}

std::vector<RationalVertex> vertex_set(const ExactPolygon& polygon) {
  std::vector<RationalVertex> r;
  for (const ExactVertex& v : polygon.vertices) {
    r.push_back({to_rational(v.x), to_rational(v.y), to_rational(v.z), to_rational(v.inv_w), {}});
    for (const Fraction& attribute : v.attributes) {
      r.back().attributes.push_back(to_rational(attribute));
    }
  }
  std::sort(r.begin(), r.end());
  return r;
}

}  // namespace clipscope::reference

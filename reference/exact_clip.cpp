// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact_clip.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <tuple>
#include <utility>

namespace clipscope::reference {
namespace {

using HalfSpace = Truth::HalfSpace;

// A value at each of the triangle's vertices; also the barycentric coordinates of a point.
using Triple = std::array<Dyadic, 3>;

template <class Function>
Triple at_vertices(const InputTriangle& triangle, const Function& function) {
  const auto& v = triangle.vertices;
  return {function(v[0]), function(v[1]), function(v[2])};
}

// The value at lambda times the sum of lambda.
Dyadic interpolate(const Triple& lambda, const Triple& values) {
  Dyadic sum = 0;
  for (int i = 0; i < 3; ++i) {
    if (!lambda[i].is_zero()) {
      sum += lambda[i] * values[i];
    }
  }
  return sum;
}

// The point where the edge from a to b meets the plane. Pre-condition: d_a > 0 > d_b, so that both
// weights are positive.
Triple meet(const Triple& a, const Dyadic& d_a, const Triple& b, const Dyadic& d_b) {
  Triple r;
  for (int i = 0; i < 3; ++i) {
    r[i] = d_a * b[i] - d_b * a[i];
  }
  return r;
}

// The part of the polygon with d >= 0, where d is given at the triangle's vertices. A segment's one
// edge is walked both ways: the vertex that it may yield twice is dropped at the end, as all are that
// coincide.
std::vector<Triple> cut(const std::vector<Triple>& polygon, const Triple& d) {
  const std::size_t n = polygon.size();
  std::vector<Dyadic> distance;
  distance.reserve(n);
  for (const Triple& vertex : polygon) {
    distance.push_back(interpolate(vertex, d));
  }
  std::vector<Triple> r;
  r.reserve(n + 1);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    const int side = distance[i].sign(), next_side = distance[next].sign();
    if (side >= 0) {
      r.push_back(polygon[i]);
    }
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

Sides sides_of(const Truth& truth, const InputTriangle& triangle) {
  Sides sides;
  for (const HalfSpace& half_space : truth.half_spaces()) {
    int outside = 0;
    for (const InputVertex& vertex : triangle.vertices) {
      outside += sign(half_space.form, vertex) < 0 ? 1 : 0;
    }
    if (outside == 3) {
      return {Verdict::rejected, {}};
    }
    if (outside > 0) {
      sides.crossed.push_back(&half_space);
    }
  }
  const bool in_front = std::ranges::all_of(
      triangle.vertices, [&](const InputVertex& v) { return sign(truth.w(), v) > 0; });
  if (!sides.crossed.empty() || !in_front) {
    sides.verdict = Verdict::clipped;
  }
  return sides;
}

// Projects barycentric points of one triangle to NDC.
class Projector {
 public:
  Projector(const Truth& truth, const InputTriangle& triangle) : truth_(truth) {
    for (int i = 0; i < 3; ++i) {
      position_[i] = at_vertices(
          triangle, [&](const InputVertex& v) { return truth.projection()[i].value(v); });
    }
    w_ = at_vertices(triangle, [&](const InputVertex& v) { return value(truth.w(), v); });
    attributes_.reserve(triangle.attribute_count);
    for (int k = 0; k < triangle.attribute_count; ++k) {
      attributes_.push_back(
          at_vertices(triangle, [&](const InputVertex& v) { return Dyadic(v.attributes[k]); }));
    }
  }

  bool is_in_front(const Triple& lambda) const { return interpolate(lambda, w_).sign() > 0; }

  // Pre-condition: is_in_front(lambda).
  ExactVertex operator()(const Triple& lambda) const {
    const Dyadic w = interpolate(lambda, w_);
    const Dyadic sum = lambda[0] + lambda[1] + lambda[2];
    ExactVertex r{
        coordinate(0, lambda, w), coordinate(1, lambda, w), coordinate(2, lambda, w), {sum, w}, {}};
    r.attributes.reserve(attributes_.size());
    for (const Triple& attribute : attributes_) {
      r.attributes.push_back({interpolate(lambda, attribute), sum});
    }
    return r;
  }

 private:
  Fraction coordinate(int i, const Triple& lambda, const Dyadic& w) const {
    return {interpolate(lambda, position_[i]), truth_.projection()[i].scale * w};
  }

  const Truth& truth_;
  std::array<Triple, 3> position_;  // clip coordinates times the scales of their rows
  Triple w_;
  std::vector<Triple> attributes_;
};

bool coincide(const ExactVertex& a, const ExactVertex& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

auto members(const RationalVertex& v) { return std::tie(v.x, v.y, v.z, v.inv_w, v.attributes); }

}  // namespace

bool operator==(const RationalVertex& a, const RationalVertex& b) {
  return members(a) == members(b);
}

bool operator<(const RationalVertex& a, const RationalVertex& b) { return members(a) < members(b); }

Verdict classify(const Truth& truth, const InputTriangle& triangle) {
  assert(is_finite(triangle));
  return sides_of(truth, triangle).verdict;
}

ExactPolygon clip(const Truth& truth, const InputTriangle& triangle) {
  assert(is_finite(triangle));
  const Sides sides = sides_of(truth, triangle);
  if (sides.verdict == Verdict::rejected) {
    return {};
  }
  std::vector<Triple> polygon = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const HalfSpace* half_space : sides.crossed) {
    polygon = cut(polygon, at_vertices(triangle, [&](const InputVertex& v) {
                    return value(half_space->form, v);
                  }));
  }
  const Projector project(truth, triangle);
  ExactPolygon r;
  for (const Triple& lambda : polygon) {
    if (!project.is_in_front(lambda)) {
      continue;
    }
    ExactVertex vertex = project(lambda);
    const bool seen =
        std::ranges::any_of(r.vertices, [&](const ExactVertex& v) { return coincide(v, vertex); });
    if (!seen) {
      r.vertices.push_back(std::move(vertex));
    }
  }
  if (!r.vertices.empty()) {
    r.verdict = sides.verdict;
  }
  return r;
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

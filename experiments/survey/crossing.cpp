// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/survey/crossing.hpp"

#include <bit>

#include "experiments/scenes/random.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"

namespace clipscope::experiments {
namespace {

constexpr double kNear = 1, kFar = 100;

double to_float(double x) { return static_cast<double>(static_cast<float>(x)); }

// In front of the near plane, in the volume's range of depth, or beyond the far plane.
double random_w(Random& random) {
  const double kind = random.uniform();
  if (kind < 0.3) return random.uniform(0.01 * kNear, kNear);
  if (kind < 0.6) return random.across_magnitudes(kNear, kFar);
  return random.across_magnitudes(kFar, 10 * kFar);
}

// Up to 16 times the volume's half width or height off its axis.
double random_offset(Random& random) {
  const double sign = random.sign();
  return sign * random.across_magnitudes(0.06, 16);
}

AttributeTriangle random_triangle(Random& random) {
  AttributeTriangle triangle;
  for (auto& v : triangle) {
    const double w = to_float(random_w(random));
    v.position[0] = to_float(random_offset(random) * w);
    v.position[1] = to_float(random_offset(random) * w * 0.5625);
    v.position[2] = -w;
    v.attributes[kSmooth] = to_float(random.uniform());
    v.attributes[kTimesW] = v.attributes[kSmooth] * w;
    v.attributes[kOwnFlat] = to_float(random.uniform());
  }
  for (auto& v : triangle) v.attributes[kProvoking] = triangle[0].attributes[kOwnFlat];
  return triangle;
}

// The planes that some vertex is outside of; 0 if all are outside of one. A sum of two products of
// floats has the right sign in double.
Outcode crossed_planes(const Frustum<double>& frustum, const AttributeTriangle& triangle) {
  Outcode all = ~Outcode{0}, any = 0;
  for (const auto& v : triangle) {
    const Outcode code = view_outcode(frustum, v.position);
    all &= code;
    any |= code;
  }
  return all == 0 ? any : 0;
}

// A first guess at planes_with_edge from a polygon clipped in double, to spare exact work.
int edges_about(const NdcPolygon<double, 4>& polygon) {
  constexpr double kClose = 1e-9;
  Outcode edges = 0;
  for (int i = 0; i < polygon.size(); ++i) {
    for (int plane = 0; plane < kPlanes; ++plane) {
      const auto on = [&](int j) {
        const double c = polygon[j].position[plane / 2];
        return std::abs(c - (plane % 2 == 0 ? -1 : 1)) < kClose;
      };
      if (on(i) && on((i + 1) % polygon.size())) edges |= Outcode{1} << plane;
    }
  }
  return std::popcount(edges);
}

// Bit by plane where the vertex lies on it, for depth in [-1, 1].
Outcode planes_at(const reference::ExactVertex& v) {
  Outcode on = 0;
  for (int i = 0; i < 3; ++i) {
    const reference::Fraction& c = coordinate(v, i);
    const reference::Dyadic negative = -c.denominator;
    if (c.numerator == negative) on |= Outcode{1} << (2 * i);
    if (c.numerator == c.denominator) on |= Outcode{1} << (2 * i + 1);
  }
  return on;
}

}  // namespace

Frustum<float> attribute_frustum() {
  return {.left = -1,
          .right = 1,
          .bottom = -0.5625f,
          .top = 0.5625f,
          .near = static_cast<float>(kNear),
          .far = static_cast<float>(kFar)};
}

Outcode planes_with_edge(const reference::ExactPolygon& polygon) {
  const auto& vertices = polygon.vertices;
  Outcode edges = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    edges |= planes_at(vertices[i]) & planes_at(vertices[(i + 1) % vertices.size()]);
  }
  return edges;
}

std::vector<AttributeTriangle> crossing_triangles(int planes, std::size_t count,
                                                  std::uint64_t seed) {
  const auto frustum = frustum_cast<double>(attribute_frustum());
  const Projection<double> projection(frustum);
  const auto truth = reference::Truth::of_frustum(frustum);
  Random random(seed * kPlanes + static_cast<std::uint64_t>(planes));
  std::vector<AttributeTriangle> triangles;
  NdcPolygon<double, 4> polygon;
  while (triangles.size() < count) {
    const AttributeTriangle triangle = random_triangle(random);
    const Outcode crossed = crossed_planes(frustum, triangle);
    if (std::popcount(crossed) != planes) continue;
    HomogeneousSutherlandHodgman{}(projection, triangle, polygon);
    if (edges_about(polygon) != planes) continue;
    const auto exact = reference::clip(truth, reference::input_triangle(triangle));
    if (exact.vertices.size() >= 3 && planes_with_edge(exact) == crossed) {
      triangles.push_back(triangle);
    }
  }
  return triangles;
}

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/attributes/wanted.hpp"

#include "experiments/scenes/random.hpp"

namespace clipscope::experiments {
namespace {

using reference::ExactVertex;
using reference::Fraction;
using Row = std::array<Exact, 3>;  // x, y, w

Exact determinant(const Row& a, const Row& b, const Row& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

Fraction product(const Fraction& a, const Fraction& b) {
  return {a.numerator * b.numerator, a.denominator * b.denominator};
}

std::array<Fraction, kModes> values_of(const ExactVertex& v) {
  return {v.attributes[kSmooth], product(v.attributes[kTimesW], v.inv_w), v.attributes[kProvoking]};
}

// A point among the vertices, never close to an edge: all weights are in [1, 2].
std::array<double, 2> point_inside(const TruthPolygon& polygon, Random& random) {
  double x = 0, y = 0, sum = 0;
  for (const std::vector<double>& v : polygon.approximation) {
    const double weight = random.uniform(1, 2);
    x += weight * v[0];
    y += weight * v[1];
    sum += weight;
  }
  return {x / sum, y / sum};
}

}  // namespace

std::array<Exact, kModes> values_at(const reference::Truth& truth,
                                    const AttributeTriangle& triangle,
                                    const std::array<double, 2>& ndc) {
  const Row p = {Exact(ndc[0]), Exact(ndc[1]), Exact(1)};
  std::array<Row, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto clip = truth.clip_position(reference::input_vertex(triangle[i]));
    corners[i] = {clip[0], clip[1], clip[3]};
  }
  const Row lambda = {determinant(p, corners[1], corners[2]),
                      determinant(corners[0], p, corners[2]),
                      determinant(corners[0], corners[1], p)};
  Exact smooth(0), sum(0), times_w(0), sum_w(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const Exact a(triangle[i].attributes[kSmooth]);
    const Exact weight_w = lambda[i] * corners[i][2];
    smooth += lambda[i] * a;
    sum += lambda[i];
    times_w += weight_w * a;
    sum_w += weight_w;
  }
  return {Exact(smooth / sum), Exact(times_w / sum_w), Exact(triangle[0].attributes[kProvoking])};
}

Wanted wanted_values(const reference::Truth& truth, const AttributeTriangle& triangle, int points,
                     std::uint64_t seed) {
  Wanted wanted{truth_polygon(truth, reference::input_triangle(triangle)), {}, {}};
  for (const ExactVertex& v : wanted.polygon.exact.vertices) {
    wanted.vertices.push_back(values_of(v));
  }
  Random random(seed);
  for (int i = 0; i < points; ++i) {
    const auto ndc = point_inside(wanted.polygon, random);
    wanted.points.push_back({ndc, values_at(truth, triangle, ndc)});
  }
  return wanted;
}

}  // namespace clipscope::experiments

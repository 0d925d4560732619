// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/attributes/measure.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "experiments/scenes/random.hpp"

namespace clipscope::experiments::attributes {
namespace {

using reference::ExactVertex;
using reference::Fraction;
using Exact3 = std::array<Exact, 3>;  // of three vertices, or x, y, w

Exact determinant(const Exact3& a, const Exact3& b, const Exact3& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

Exact weighted_mean(const Exact3& weights, const Exact3& values) {
  const Exact sum = weights[0] * values[0] + weights[1] * values[1] + weights[2] * values[2];
  return Exact(sum / (weights[0] + weights[1] + weights[2]));
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

// What is wanted, and the attribute that carries it, by treatment.
constexpr std::array kWanted = {Mode::smooth, Mode::noperspective, Mode::noperspective, Mode::flat};
constexpr std::array kCarrier = {kSmooth, kTimesW, kSmooth, kProvoking};

// The value that the pipeline has at a vertex.
Number value_of(const Format& format, const VertexView& v, std::size_t treatment) {
  const Number value = v.attribute(kCarrier[treatment]);
  return kCarrier[treatment] == kTimesW ? product(format, value, v[3]) : value;
}

// Twice the signed area of three points.
template <class N>
N doubled_area(const std::array<N, 2>& a, const std::array<N, 2>& b, const std::array<N, 2>& c) {
  return N((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
}

template <class N>
std::array<N, 3> weights_of(const std::array<std::array<N, 2>, 3>& t, const std::array<N, 2>& p) {
  return {doubled_area(t[1], t[2], p), doubled_area(t[2], t[0], p), doubled_area(t[0], t[1], p)};
}

// A triangle of a polygon's fan; weights of its vertices at a point of the screen, not normalised.
struct FanPoint {
  std::array<VertexView, 3> vertices;
  Exact3 weights;
};

// The triangle of the fan that holds the point. The polygon is rounded and the point well inside of
// the exact one; the triangle that it is deepest in, or least outside of, is found in double, which
// is all that a choice between neighbours on a shared diagonal needs.
FanPoint locate(const PolygonView& polygon, const std::array<double, 2>& ndc) {
  std::size_t best = 2;
  double deepest = -HUGE_VAL;
  const auto at = [&](std::size_t i) {
    return std::array{polygon[i][0].value, polygon[i][1].value};
  };
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const auto w = weights_of<double>({at(0), at(i - 1), at(i)}, ndc);
    const double sum = w[0] + w[1] + w[2];  // negative where the polygon turns clockwise
    const double depth = std::min({w[0] / sum, w[1] / sum, w[2] / sum});
    if (depth > deepest) {
      deepest = depth;
      best = i;
    }
  }
  const std::array vertices = {polygon[0], polygon[best - 1], polygon[best]};
  const auto exactly = [&](std::size_t i) {
    return std::array{to_exact(vertices[i][0]), to_exact(vertices[i][1])};
  };
  return {vertices,
          weights_of<Exact>({exactly(0), exactly(1), exactly(2)}, {Exact(ndc[0]), Exact(ndc[1])})};
}

// The value that is drawn at the point, exactly computed from the polygon's vertices.
Exact drawn_value(const Format& format, const FanPoint& point, std::size_t treatment) {
  Exact3 weights = point.weights, values;
  for (std::size_t i = 0; i < 3; ++i) {
    const VertexView& v = point.vertices[i];
    if (kWanted[treatment] != Mode::noperspective) weights[i] *= to_exact(v[3]);
    values[i] = to_exact(value_of(format, v, treatment));
  }
  return weighted_mean(weights, values);
}

struct VertexError {
  double absolute = 0, ulp = 0;
};

struct TriangleErrors {
  bool right = false;
  std::array<std::vector<VertexError>, kTreatments> vertices;
  std::array<double, kTreatments> inside{};
  bool first_changed = false, last_changed = false, constant_changed = false;
};

void judge_vertices(const PolygonView& polygon, const Wanted& wanted, TriangleErrors& errors) {
  const Format& format = polygon.format();
  const std::vector<VertexView> vertices = matched_vertices(polygon, wanted.polygon).value();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const VertexView& v = vertices[i];
    for (std::size_t t = 0; t < kTreatments; ++t) {
      const reference::Fraction& exact = wanted.vertices[i][static_cast<std::size_t>(kWanted[t])];
      const double error = std::abs(reference::error_of(to_exact(value_of(format, v, t)), exact));
      const double ulp = format.ulp_at(reference::approximate(exact));
      errors.vertices[t].push_back({error, error == 0 ? 0 : error / ulp});
    }
  }
}

void judge_inside(const PolygonView& polygon, const Wanted& wanted, TriangleErrors& errors) {
  for (const SamplePoint& sample : wanted.points) {
    const FanPoint point = locate(polygon, sample.ndc);
    for (std::size_t t = 0; t < kTreatments; ++t) {
      const Exact& exact = sample.value[static_cast<std::size_t>(kWanted[t])];
      const double error = nearest_double(Exact(drawn_value(polygon.format(), point, t) - exact));
      errors.inside[t] = std::max(errors.inside[t], std::abs(error));
    }
  }
}

void judge_flat(const PolygonView& polygon, const AttributeTriangle& triangle,
                TriangleErrors& errors) {
  const auto differs = [](const VertexView& v, int attribute, double wanted) {
    return to_exact(v.attribute(attribute)) != Exact(wanted);
  };
  const double first = triangle[0].attributes[kOwnFlat], last = triangle[2].attributes[kOwnFlat];
  errors.first_changed = differs(polygon[0], kOwnFlat, first);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    errors.constant_changed |= differs(polygon[i], kProvoking, first);
    errors.last_changed |= i >= 2 && differs(polygon[i], kOwnFlat, last);
  }
}

TriangleErrors judge(const PolygonView& polygon, const AttributeTriangle& triangle,
                     const Wanted& wanted) {
  TriangleErrors errors;
  errors.right = compare(polygon, wanted.polygon).outcome <= Outcome::visible;
  if (!errors.right) return errors;
  judge_vertices(polygon, wanted, errors);
  judge_inside(polygon, wanted, errors);
  judge_flat(polygon, triangle, errors);
  return errors;
}

void add(const TriangleErrors& errors, std::size_t triangle, Tally& tally) {
  if (!errors.right) {
    ++tally.wrong;
    return;
  }
  ++tally.triangles;
  tally.first_changed += errors.first_changed;
  tally.last_changed += errors.last_changed;
  tally.constant_changed += errors.constant_changed;
  for (std::size_t t = 0; t < kTreatments; ++t) {
    for (const VertexError& e : errors.vertices[t]) {
      tally.errors[t].absolute.add(e.absolute);
      tally.errors[t].ulp.add(e.ulp);
      if (static_cast<Treatment>(t) == Treatment::smooth && e.absolute > tally.worst) {
        tally.worst = e.absolute;
        tally.worst_at = triangle;
      }
    }
    tally.errors[t].inside = std::max(tally.errors[t].inside, errors.inside[t]);
  }
}

}  // namespace

std::array<Exact, kModes> values_at(const reference::Truth& truth,
                                    const AttributeTriangle& triangle,
                                    const std::array<double, 2>& ndc) {
  const Exact3 p = {Exact(ndc[0]), Exact(ndc[1]), Exact(1)};
  std::array<Exact3, 3> corners;
  Exact3 values;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto clip = truth.clip_position(reference::input_vertex(triangle[i]));
    corners[i] = {clip[0], clip[1], clip[3]};
    values[i] = Exact(triangle[i].attributes[kSmooth]);
  }
  Exact3 lambda = {determinant(p, corners[1], corners[2]), determinant(corners[0], p, corners[2]),
                   determinant(corners[0], corners[1], p)};
  const Exact smooth = weighted_mean(lambda, values);
  for (std::size_t i = 0; i < 3; ++i) lambda[i] *= corners[i][2];
  return {smooth, weighted_mean(lambda, values), Exact(triangle[0].attributes[kProvoking])};
}

std::vector<Wanted> wanted_values(std::span<const AttributeTriangle> triangles, int points,
                                  std::uint64_t seed) {
  const auto truth = reference::Truth::of_frustum(frustum_cast<double>(attribute_frustum()));
  std::vector<Wanted> all(triangles.size());
  tbb::parallel_for(std::size_t{0}, triangles.size(), [&](std::size_t i) {
    Wanted& wanted = all[i];
    wanted.polygon = truth_polygon(truth, reference::input_triangle(triangles[i]));
    for (const ExactVertex& v : wanted.polygon.exact.vertices) {
      wanted.vertices.push_back(values_of(v));
    }
    Random random(seed + i);
    for (int p = 0; p < points; ++p) {
      const auto ndc = point_inside(wanted.polygon, random);
      wanted.points.push_back({ndc, values_at(truth, triangles[i], ndc)});
    }
  });
  return all;
}

Tally measure_errors(const Contestant& contestant, std::span<const AttributeTriangle> triangles,
                     std::span<const Wanted> wanted) {
  const Answers answers = clip(contestant, batch_of(attribute_frustum(), triangles));
  std::vector<TriangleErrors> errors(triangles.size());
  tbb::parallel_for(std::size_t{0}, triangles.size(),
                    [&](std::size_t i) { errors[i] = judge(answers[i], triangles[i], wanted[i]); });
  Tally tally;
  for (std::size_t i = 0; i < errors.size(); ++i) add(errors[i], i, tally);
  return tally;
}

}  // namespace clipscope::experiments::attributes

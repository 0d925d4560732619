// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/attributes/attribute_errors.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "experiments/measure/batches.hpp"
#include "experiments/measure/match.hpp"

namespace clipscope::experiments {
namespace {

constexpr int K = kSceneAttributes;

template <class T>
using NdcSpan = std::span<const NdcVertex<T, K>>;

// What is wanted under a treatment.
Mode wanted_mode(Treatment treatment) {
  switch (treatment) {
    case Treatment::times_w:
    case Treatment::noperspective: return Mode::noperspective;
    case Treatment::flat: return Mode::flat;
    case Treatment::smooth: break;
  }
  return Mode::smooth;
}

// The value that the pipeline has at a vertex.
template <class T>
T value_of(const NdcVertex<T, K>& v, Treatment treatment) {
  if (treatment == Treatment::times_w) return T(v.attributes[kTimesW] * v.position[3]);
  return v.attributes[treatment == Treatment::flat ? kProvoking : kSmooth];
}

// A point of the screen as weights of three vertices of a polygon, not normalised.
struct FanPoint {
  std::array<std::size_t, 3> vertex;
  std::array<Exact, 3> weight;
};

// Twice the signed area of three points.
template <class N>
N doubled_area(const std::array<N, 2>& a, const std::array<N, 2>& b, const std::array<N, 2>& c) {
  return N((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
}

template <class N>
std::array<N, 3> weights_of(const std::array<std::array<N, 2>, 3>& t, const std::array<N, 2>& p) {
  return {doubled_area(t[1], t[2], p), doubled_area(t[2], t[0], p), doubled_area(t[0], t[1], p)};
}

// The triangle of the fan that holds the point. The polygon is rounded and the point well inside of the
// exact one; the triangle that it is deepest in, or least outside of, is found in double, which is all
// that a choice between neighbours on a shared diagonal needs.
template <class T>
FanPoint locate(NdcSpan<T> polygon, const std::array<double, 2>& ndc) {
  std::size_t best = 2;
  double deepest = -HUGE_VAL;
  const auto at = [&](std::size_t i) {
    return std::array{nearest_double(polygon[i].position[0]),
                      nearest_double(polygon[i].position[1])};
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
  const auto exactly = [&](std::size_t i) {
    return std::array{to_exact(polygon[i].position[0]), to_exact(polygon[i].position[1])};
  };
  return {{0, best - 1, best},
          weights_of<Exact>({exactly(0), exactly(best - 1), exactly(best)},
                            {Exact(ndc[0]), Exact(ndc[1])})};
}

// The value that is drawn at the point, exactly computed from the polygon's vertices.
template <class T>
Exact drawn_value(NdcSpan<T> polygon, const FanPoint& point, Treatment treatment) {
  Exact value(0), sum(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const NdcVertex<T, K>& v = polygon[point.vertex[i]];
    Exact weight = point.weight[i];
    if (wanted_mode(treatment) != Mode::noperspective) weight *= to_exact(v.position[3]);
    value += weight * to_exact(value_of(v, treatment));
    sum += weight;
  }
  return Exact(value / sum);
}

struct VertexError {
  double absolute = 0, ulp = 0;
};

template <class T>
VertexError vertex_error(const T& value, const reference::Fraction& wanted) {
  const double error = std::abs(reference::error_of(to_exact(value), wanted));
  if (error == 0) return {};
  return {error, error / ulp_at<T>(reference::approximate(wanted))};
}

struct TriangleErrors {
  bool right = false;
  std::array<std::vector<VertexError>, kTreatments> vertices;
  std::array<double, kTreatments> inside{};
  bool first_changed = false, last_changed = false, constant_changed = false;
};

template <class T>
void judge_vertices(NdcSpan<T> polygon, const Wanted& wanted, TriangleErrors& errors) {
  const auto vertices = distinct_vertices<T, K>(polygon);
  std::vector<ScreenPoint> expected, found;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::vector<double>& v = wanted.polygon.approximation[i];
    expected.push_back(screen_point(v[0], v[1]));
    found.push_back(screen_point(*vertices[i]));
  }
  const std::size_t rotation = best_rotation(expected, found);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const NdcVertex<T, K>& v = *vertices[(i + rotation) % vertices.size()];
    for (std::size_t t = 0; t < kTreatments; ++t) {
      const auto treatment = static_cast<Treatment>(t);
      const auto mode = static_cast<std::size_t>(wanted_mode(treatment));
      errors.vertices[t].push_back(vertex_error(value_of(v, treatment), wanted.vertices[i][mode]));
    }
  }
}

template <class T>
void judge_inside(NdcSpan<T> polygon, const Wanted& wanted, TriangleErrors& errors) {
  for (const SamplePoint& sample : wanted.points) {
    const FanPoint point = locate<T>(polygon, sample.ndc);
    for (std::size_t t = 0; t < kTreatments; ++t) {
      const auto treatment = static_cast<Treatment>(t);
      const auto mode = static_cast<std::size_t>(wanted_mode(treatment));
      const Exact error = drawn_value<T>(polygon, point, treatment) - sample.value[mode];
      errors.inside[t] = std::max(errors.inside[t], std::abs(nearest_double(error)));
    }
  }
}

template <class T>
void judge_flat(NdcSpan<T> polygon, const AttributeTriangle& triangle, TriangleErrors& errors) {
  const auto first = scalar_from<T>(triangle[0].attributes[kOwnFlat]);
  const auto last = scalar_from<T>(triangle[2].attributes[kOwnFlat]);
  errors.first_changed = polygon[0].attributes[kOwnFlat] != first;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    errors.constant_changed |= polygon[i].attributes[kProvoking] != first;
    errors.last_changed |= i >= 2 && polygon[i].attributes[kOwnFlat] != last;
  }
}

template <class T>
TriangleErrors judge(NdcSpan<T> polygon, const AttributeTriangle& triangle, const Wanted& wanted) {
  TriangleErrors errors;
  errors.right = compare<T, K>(polygon, wanted.polygon).outcome <= Outcome::visible;
  if (!errors.right) return errors;
  judge_vertices<T>(polygon, wanted, errors);
  judge_inside<T>(polygon, wanted, errors);
  judge_flat<T>(polygon, triangle, errors);
  return errors;
}

void add(const TriangleErrors& errors, std::size_t triangle, AttributeTally& tally) {
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
      if (t == static_cast<std::size_t>(Treatment::smooth) && e.absolute > tally.worst) {
        tally.worst = e.absolute;
        tally.worst_at = triangle;
      }
    }
    tally.errors[t].inside = std::max(tally.errors[t].inside, errors.inside[t]);
  }
}

// Each number rounded to T once.
template <class T>
ViewTriangle<T, K> cast(const AttributeTriangle& triangle) {
  ViewTriangle<T, K> r;
  for (std::size_t i = 0; i < 3; ++i) {
    for (int c = 0; c < 3; ++c) r[i].position[c] = scalar_from<T>(triangle[i].position[c]);
    for (int k = 0; k < K; ++k) r[i].attributes[k] = scalar_from<T>(triangle[i].attributes[k]);
  }
  return r;
}

}  // namespace

AttributeTally attribute_errors(const AnyContestant& any,
                                std::span<const AttributeTriangle> triangles,
                                std::span<const Wanted> wanted) {
  std::vector<TriangleErrors> errors(triangles.size());
  std::visit(
      [&]<class T>(const Contestant<T>* contestant) {
        std::vector<ViewTriangle<T, K>> input;
        for (const AttributeTriangle& triangle : triangles) input.push_back(cast<T>(triangle));
        PolygonStream<T, K> polygons;
        contestant->view(projection_from<T>(frustum_cast<double>(attribute_frustum())), input,
                         polygons);
        tbb::parallel_for(std::size_t{0}, triangles.size(), [&](std::size_t i) {
          errors[i] = judge<T>(polygons[i], triangles[i], wanted[i]);
        });
      },
      any);
  AttributeTally tally;
  for (std::size_t i = 0; i < errors.size(); ++i) add(errors[i], i, tally);
  return tally;
}

std::string attribute_options() {
  const Frustum<float> f = attribute_frustum();
  return fmt::format("--space view --frustum {},{},{},{},{},{} --attributes {}", f.left, f.right,
                     f.bottom, f.top, f.near, f.far, K);
}

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/measure/compare.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/measure/match.hpp"
#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {
namespace {

using reference::ExactVertex;
using reference::Fraction;

// Whether x, y, z and the attributes are finite. 1/w may overflow: where the exact one does, too, that is
// right.
template <class T, int K>
bool is_usable(NdcVertex<T, K> v) {
  if (is_nan(v.position[3])) return false;
  v.position[3] = T(1);
  return is_finite(v);
}

// The error of an infinite value: none if the exact one rounds to it.
template <class T>
double overflow_error(const Fraction& exact) {
  const bool overflows = ScalarTraits<T>::precision == 24
                             ? std::isinf(reference::round_to<float>(exact))
                             : std::isinf(reference::round_to<double>(exact));
  return overflows ? 0 : std::numeric_limits<double>::infinity();
}

// value - exact. The difference to the approximation, itself good to 2^-50, is good enough unless most
// of it cancels.
template <class T>
double coordinate_error(const T& value, const Fraction& exact, double approximation) {
  if (!is_finite(value)) return overflow_error<T>(exact);
  if constexpr (ScalarTraits<T>::precision > 0 && ScalarTraits<T>::precision <= 53) {
    const double difference = nearest_double(value) - approximation;
    if (std::abs(difference) > 0x1p-30 * std::abs(approximation)) {
      return difference;
    }
    return reference::error_of(nearest_double(value), exact);
  } else {
    return reference::error_of(to_exact(value), exact);
  }
}

template <class T>
double error_in_ulp(double error, double exact) {
  if (error == 0.0) return 0.0;
  const double ulp = ulp_at<T>(exact);
  return ulp == 0.0 ? std::numeric_limits<double>::infinity() : std::abs(error) / ulp;
}

using Points = std::vector<ScreenPoint>;

Points screen_points(const TruthPolygon& truth) {
  Points points;
  for (const std::vector<double>& v : truth.approximation) {
    points.push_back(screen_point(v[0], v[1]));
  }
  return points;
}

template <class Vertices>
Points screen_points(const Vertices& vertices) {
  Points points;
  for (const auto* v : vertices) points.push_back(screen_point(*v));
  return points;
}

double signed_area(const Points& p) {
  double area = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto& a = p[i];
    const auto& b = p[(i + 1) % p.size()];
    area += (a[0] * b[1] - a[1] * b[0]) / 2;
  }
  return area;
}

bool is_turned_round(const Points& truth, const Points& segment) {
  const auto direction = [](const Points& p) {
    return std::array{p.back()[0] - p.front()[0], p.back()[1] - p.front()[1]};
  };
  const auto a = direction(truth), b = direction(segment);
  return std::hypot(a[0], a[1]) > 1 && std::hypot(b[0], b[1]) > 1 && a[0] * b[0] + a[1] * b[1] < 0;
}

bool is_flipped(const Points& truth, const Points& polygon) {
  if (truth.size() == 2 && polygon.size() == 2) return is_turned_round(truth, polygon);
  constexpr double kSmallArea = 1.0;  // px^2: below it rounding may turn a sliver over
  const double a = signed_area(truth);
  const double b = signed_area(polygon);
  return std::min(std::abs(a), std::abs(b)) > kSmallArea && (a < 0) != (b < 0);
}

Outcome category(const Comparison& errors) {
  if (errors.position_ulp <= 0.5) return Outcome::exact;
  if (errors.position_ulp <= 1.0) return Outcome::faithful;
  return errors.position_px < kSubpixel ? Outcome::subpixel : Outcome::visible;
}

template <class T, int K>
void add_errors(const NdcVertex<T, K>& vertex, const ExactVertex& exact,
                const std::vector<double>& approximation, Comparison& errors) {
  std::array<double, 2> pixels{};
  for (int i = 0; i < 4; ++i) {
    const double a = approximation[static_cast<std::size_t>(i)];
    const double error = coordinate_error(vertex.position[i], coordinate(exact, i), a);
    errors.position_ulp = std::max(errors.position_ulp, error_in_ulp<T>(error, a));
    if (i == 0) pixels[0] = error * kScreenWidth / 2;
    if (i == 1) pixels[1] = error * kScreenHeight / 2;
  }
  errors.position_px = std::max(errors.position_px, std::hypot(pixels[0], pixels[1]));
  for (int k = 0; k < vertex.attributes.size(); ++k) {
    const double a = approximation[static_cast<std::size_t>(4 + k)];
    const double error = coordinate_error(vertex.attributes[k], coordinate(exact, 4 + k), a);
    errors.attribute = std::max(errors.attribute, std::abs(error));
  }
}

}  // namespace

const Fraction& coordinate(const ExactVertex& v, int i) {
  switch (i) {
    case 0: return v.x;
    case 1: return v.y;
    case 2: return v.z;
    case 3: return v.inv_w;
    default: return v.attributes[static_cast<std::size_t>(i - 4)];
  }
}

TruthPolygon truth_polygon(const reference::Truth& truth,
                           const reference::InputTriangle& triangle) {
  return truth_polygon(truth, triangle.vertices, triangle.attribute_count);
}

TruthPolygon truth_polygon(const reference::Truth& truth,
                           std::span<const reference::InputVertex> vertices, int attribute_count) {
  TruthPolygon result{reference::clip(truth, vertices, attribute_count),
                      {},
                      std::min<std::size_t>(3, vertices.size())};
  for (const ExactVertex& v : result.exact.vertices) {
    std::vector<double>& numbers = result.approximation.emplace_back();
    for (int i = 0; i < 4 + attribute_count; ++i) {
      numbers.push_back(reference::approximate(coordinate(v, i)));
    }
  }
  return result;
}

template <class T, int K>
Comparison compare(std::span<const NdcVertex<T, K>> polygon, const TruthPolygon& truth) {
  Comparison result;
  result.visible = truth.is_visible() || !polygon.empty();
  if (!std::all_of(polygon.begin(), polygon.end(), is_usable<T, K>)) {
    result.outcome = Outcome::not_finite;
    return result;
  }
  const auto vertices = distinct_vertices(polygon);
  if (vertices.size() < truth.needed) {
    result.visible = truth.is_visible();
    result.outcome = truth.is_visible() ? Outcome::missing : Outcome::exact;
    return result;
  }
  if (!truth.is_visible()) {
    result.outcome = Outcome::extra;
    return result;
  }
  const Points expected = screen_points(truth);
  const Points found = screen_points(vertices);
  if (is_flipped(expected, found)) {
    result.outcome = Outcome::flipped;
    return result;
  }
  if (expected.size() != found.size()) {
    result.outcome = Outcome::vertex_count;
    return result;
  }
  // A segment keeps its order.
  const std::size_t rotation = found.size() == 2 ? 0 : best_rotation(expected, found);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    add_errors(*vertices[(i + rotation) % vertices.size()], truth.exact.vertices[i],
               truth.approximation[i], result);
  }
  result.outcome = category(result);
  return result;
}

template <class T, int K>
using NdcSpan = std::span<const NdcVertex<T, K>>;
template Comparison compare(NdcSpan<float, kSceneAttributes>, const TruthPolygon&);
template Comparison compare(NdcSpan<float, kRunTime>, const TruthPolygon&);
template Comparison compare(NdcSpan<double, kSceneAttributes>, const TruthPolygon&);
template Comparison compare(NdcSpan<double, kRunTime>, const TruthPolygon&);
template Comparison compare(NdcSpan<dd_real, kSceneAttributes>, const TruthPolygon&);
template Comparison compare(NdcSpan<dd_real, kRunTime>, const TruthPolygon&);
template Comparison compare(NdcSpan<Exact, kSceneAttributes>, const TruthPolygon&);
template Comparison compare(NdcSpan<Exact, kRunTime>, const TruthPolygon&);
template Comparison compare(NdcSpan<Counted, kSceneAttributes>, const TruthPolygon&);
template Comparison compare(NdcSpan<Counted, kRunTime>, const TruthPolygon&);

}  // namespace clipscope::experiments

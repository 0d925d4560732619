// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/compare.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "experiments/judge/depth_error.hpp"
#include "experiments/judge/match.hpp"

namespace clipscope::experiments {
namespace {

using reference::ExactVertex;
using reference::Fraction;

// Whether x, y, z and the attributes are finite. 1/w may overflow: where the exact one does, too,
// that is right.
bool is_usable(const VertexView& v) {
  constexpr std::size_t kInverseW = 3;
  for (std::size_t i = 0; i < v.size(); ++i) {
    if (i == kInverseW ? is_nan(v[i]) : !is_finite(v[i])) return false;
  }
  return true;
}

// The error of an infinite value: none if the exact one rounds to it.
double overflow_error(const Format& format, const Fraction& exact) {
  const bool overflows = format.is_float() ? std::isinf(reference::round_to<float>(exact))
                                           : std::isinf(reference::round_to<double>(exact));
  return overflows ? 0 : std::numeric_limits<double>::infinity();
}

// value - exact. The difference to the approximation, itself good to 2^-50, is good enough unless
// most of it cancels.
double coordinate_error(const Format& format, const Number& number, const Fraction& exact,
                        double approximation) {
  if (!is_finite(number)) return overflow_error(format, exact);
  if (format.is_exact() || format.precision > 53) {
    return reference::error_of(to_exact(number), exact);
  }
  const double difference = number.value - approximation;
  if (std::abs(difference) > 0x1p-30 * std::abs(approximation)) return difference;
  return reference::error_of(number.value, exact);
}

double error_in_ulp(const Format& format, double error, double exact) {
  if (error == 0.0) return 0.0;
  const double ulp = format.ulp_at(exact);
  return ulp == 0.0 ? std::numeric_limits<double>::infinity() : std::abs(error) / ulp;
}

using Points = std::vector<ScreenPoint>;

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

// A segment keeps its order.
std::size_t rotation_between(const Points& truth, const Points& polygon) {
  return polygon.size() == 2 ? 0 : best_rotation(truth, polygon);
}

Outcome category(const Comparison& errors) {
  if (errors.position_ulp <= 0.5) return Outcome::exact;
  if (errors.position_ulp <= 1.0) return Outcome::faithful;
  return errors.position_px < kSubpixel ? Outcome::subpixel : Outcome::visible;
}

void add_errors(const Format& format, const VertexView& vertex, const ExactVertex& exact,
                const std::vector<double>& approximation, Comparison& errors) {
  const auto error_of = [&](std::size_t i) {
    return coordinate_error(format, vertex[i], coordinate(exact, static_cast<int>(i)),
                            approximation[i]);
  };
  std::array<double, 2> pixels{};
  for (std::size_t i = 0; i < 4; ++i) {
    const double error = error_of(i);
    errors.position_ulp =
        std::max(errors.position_ulp, error_in_ulp(format, error, approximation[i]));
    if (i == 0) pixels[0] = error * kScreenWidth / 2;
    if (i == 1) pixels[1] = error * kScreenHeight / 2;
  }
  errors.position_px = std::max(errors.position_px, std::hypot(pixels[0], pixels[1]));
  for (std::size_t i = 4; i < vertex.size(); ++i) {
    errors.attribute = std::max(errors.attribute, std::abs(error_of(i)));
  }
}

// Pre-condition: as many vertices as the truth has, vertex i for its vertex i.
Comparison compared(const Format& format, const std::vector<VertexView>& vertices,
                    const TruthPolygon& truth) {
  Comparison errors{.visible = true};
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    add_errors(format, vertices[i], truth.exact.vertices[i], truth.approximation[i], errors);
  }
  errors.outcome = category(errors);
  return errors;
}

// Vertex (i + rotation) % n as vertex i. Polygon: a view of one, or a list of its vertices.
template <class Polygon>
std::vector<VertexView> rotated(const Polygon& polygon, std::size_t rotation) {
  std::vector<VertexView> vertices;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    vertices.push_back(polygon[(i + rotation) % polygon.size()]);
  }
  return vertices;
}

// Vertices that are apart in truth may fall together in a format: all vertices of an answer that
// has as many as the truth, each within an ulp.
std::optional<std::vector<VertexView>> matched_with_repeats(const PolygonView& polygon,
                                                            const TruthPolygon& truth) {
  const std::size_t n = polygon.size();
  if (n != truth.exact.vertices.size()) return {};
  const std::size_t rotations = n == 2 ? 1 : n;  // a segment keeps its order
  for (std::size_t rotation = 0; rotation < rotations; ++rotation) {
    std::vector<VertexView> vertices = rotated(polygon, rotation);
    if (compared(polygon.format(), vertices, truth).outcome <= Outcome::faithful) return vertices;
  }
  return {};
}

// distinct: the answer's vertices but repeated ones.
std::optional<std::vector<VertexView>> matched(const PolygonView& polygon,
                                               const std::vector<VertexView>& distinct,
                                               const TruthPolygon& truth) {
  if (distinct.size() < polygon.size()) {
    if (auto vertices = matched_with_repeats(polygon, truth)) return vertices;
  }
  if (distinct.size() != truth.exact.vertices.size()) return {};
  return rotated(distinct,
                 rotation_between(screen_points(truth.approximation), screen_points(distinct)));
}

Outcome outcome_of(Failure::Kind kind) {
  switch (kind) {
    case Failure::Kind::crashed: return Outcome::crashed;
    case Failure::Kind::timed_out: return Outcome::timed_out;
    case Failure::Kind::malformed: return Outcome::malformed;
  }
  return Outcome::crashed;
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

float nearest_float(const Number& x, const Format& format) {
  using Limits = std::numeric_limits<float>;
  const float f = static_cast<float>(x.value);
  if (format.is_float() || &format == &kFormat<double>) return f;  // one rounding
  if (!is_finite(x) || !std::isfinite(f)) return f;
  for (const float limit : {Limits::lowest(), Limits::max()}) {
    const float neighbour = std::nextafter(f, limit);
    const double middle = (double{f} + double{neighbour}) / 2;  // exact: 25 bits
    // The double is at most one of its units off; away from the middle the side is settled.
    if (std::abs(x.value - middle) > std::abs(middle) * 0x1p-50) continue;
    const Exact value = to_exact(x), exact_middle(middle);
    if (value == exact_middle) return static_cast<float>(middle);
    if (limit < 0 ? value < exact_middle : exact_middle < value) return neighbour;
  }
  return f;
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

std::vector<TruthPolygon> truth_polygons(const reference::Truth& truth, const Batch& batch) {
  std::vector<TruthPolygon> truths(batch.size());
  tbb::parallel_for(std::size_t{0}, truths.size(), [&](std::size_t i) {
    truths[i] = truth_polygon(truth, input_vertices(batch, i), batch.attributes);
  });
  return truths;
}

Comparison compare(const PolygonView& polygon, const TruthPolygon& truth) {
  Comparison result;
  result.visible = truth.is_visible() || !polygon.empty();
  const auto with = [&](Outcome outcome) {
    result.outcome = outcome;
    return result;
  };
  if (polygon.failure()) {
    result.visible = true;
    return with(outcome_of(polygon.failure()->kind));
  }
  if (!std::ranges::all_of(polygon, is_usable)) return with(Outcome::not_finite);
  const std::vector<VertexView> distinct = distinct_vertices(polygon);
  if (!truth.is_visible()) {
    result.visible = distinct.size() >= truth.needed;
    return with(result.visible ? Outcome::extra : Outcome::exact);
  }
  const auto vertices = matched(polygon, distinct, truth);
  if (!vertices && distinct.size() < truth.needed) return with(Outcome::missing);
  if (is_flipped(screen_points(truth.approximation), screen_points(distinct))) {
    return with(Outcome::flipped);
  }
  return vertices ? compared(polygon.format(), *vertices, truth) : with(Outcome::vertex_count);
}

std::optional<std::vector<VertexView>> matched_vertices(const PolygonView& polygon,
                                                        const TruthPolygon& truth) {
  if (!truth.is_visible()) return {};
  return matched(polygon, distinct_vertices(polygon), truth);
}

double largest_depth_error(const PolygonView& polygon, const TruthPolygon& truth) {
  constexpr std::size_t kDepth = 2;
  double largest = 0;
  const auto vertices = matched_vertices(polygon, truth);
  for (std::size_t i = 0; vertices && i < vertices->size(); ++i) {
    const Number z = (*vertices)[i][kDepth];
    largest =
        std::max(largest, std::abs(coordinate_error(polygon.format(), z, truth.exact.vertices[i].z,
                                                    truth.approximation[i][kDepth])));
  }
  return largest;
}

std::vector<Comparison> compare(const Answers& answers, std::span<const TruthPolygon> truths) {
  std::vector<Comparison> comparisons(answers.size());
  tbb::parallel_for(std::size_t{0}, comparisons.size(),
                    [&](std::size_t i) { comparisons[i] = compare(answers[i], truths[i]); });
  return comparisons;
}

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/plane_order/measure.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "experiments/measure/batches.hpp"
#include "experiments/measure/compare.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kChunk = 32;  // triangles that are tallied together
constexpr int K = kSceneAttributes;

// For each of the 720 orders the order of the planes to which it amounts.
using Restrictions = std::array<std::uint16_t, kOrders>;

const Restrictions& restrictions(Outcode planes) {
  static const auto all = [] {
    std::array<Restrictions, 1u << kPlanes> table;
    for (Outcode code = 0; code < table.size(); ++code) {
      for (std::size_t o = 0; o < kOrders; ++o) {
        table[code][o] = static_cast<std::uint16_t>(restricted(all_orders()[o], code));
      }
    }
    return table;
  }();
  return all[planes];
}

std::size_t near_first_of(Outcode planes) { return restricted(near_first_order(), planes); }

template <class T>
using NdcSpan = std::span<const NdcVertex<T, K>>;

template <class T>
NdcSpan<T> span_of(const NdcPolygon<T, K>& polygon) {
  return {polygon.begin(), polygon.end()};
}

template <class T>
bool same_bits(const NdcVertex<T, K>& a, const NdcVertex<T, K>& b) {
  return a.position == b.position && a.attributes.values == b.attributes.values;
}

template <class T>
bool same_up_to_rotation(const NdcPolygon<T, K>& a, const NdcPolygon<T, K>& b) {
  const int n = a.size();
  if (n != b.size()) return false;
  for (int shift = 0; shift < std::max(n, 1); ++shift) {
    int equal = 0;
    while (equal < n && same_bits(a[equal], b[(equal + shift) % n])) ++equal;
    if (equal == n) return true;
  }
  return false;
}

// The largest distance of a vertex of one from the nearest vertex of the other; 0 if either has none.
template <class T>
double distance_px(const NdcPolygon<T, K>& a, const NdcPolygon<T, K>& b) {
  double largest = 0;
  const auto from = [&](const NdcPolygon<T, K>& x, const NdcPolygon<T, K>& y) {
    for (const auto& p : x) {
      double nearest = HUGE_VAL;
      for (const auto& q : y) {
        const T dx = p.position[0] - q.position[0], dy = p.position[1] - q.position[1];
        nearest = std::min(nearest, std::hypot(nearest_double(dx) * kScreenWidth / 2,
                                               nearest_double(dy) * kScreenHeight / 2));
      }
      largest = std::max(largest, nearest);
    }
  };
  if (a.empty() || b.empty()) return 0;
  from(a, b);
  from(b, a);
  return largest;
}

// Results with the same bits share a number, so that each is judged once. results[i] has the bits of
// results[first_like[i]].
template <class T>
std::vector<std::size_t> first_like(const std::vector<OrderedCut<T, K>>& results) {
  std::vector<std::size_t> first(results.size()), distinct;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const auto known = std::find_if(distinct.begin(), distinct.end(), [&](std::size_t d) {
      return same_up_to_rotation(results[d].polygon, results[i].polygon);
    });
    first[i] = known == distinct.end() ? i : *known;
    if (known == distinct.end()) distinct.push_back(i);
  }
  return first;
}

template <class T>
OrderTally judged(const OrderedCut<T, K>& result, const OrderedCut<T, K>& near_first,
                  const TruthPolygon& truth) {
  const Comparison comparison = compare<T, K>(span_of(result.polygon), truth);
  OrderTally tally;
  tally.differs = !same_up_to_rotation(result.polygon, near_first.polygon);
  tally.other_outline = result.polygon.size() != near_first.polygon.size();
  tally.wrong = comparison.visible && is_failure(comparison.outcome);
  tally.moved_px = distance_px(result.polygon, near_first.polygon);
  if (comparison.outcome <= Outcome::visible) tally.error_px = comparison.position_px;
  return tally;
}

template <class T>
void add_triangle(const TriangleSet& set, std::size_t index, const reference::Truth& truth_of_clip,
                  RoundedOrders& sum) {
  const CutTriangle& input = set.triangles[index];
  const auto truth = truth_polygon(truth_of_clip, reference::input_triangle(input.triangle));
  const auto results =
      OrderTree<T, K>::cut_all(set.depth, input.planes, simplex_cast<T>(input.triangle));
  const auto first = first_like(results);
  const auto& near_first = results[near_first_of(input.planes)];
  std::vector<OrderTally> tallies(results.size());
  std::size_t distinct = 0, empty = 0, wrong = 0;
  for (std::size_t i = 0; i < results.size(); ++i) {
    distinct += first[i] == i;
    tallies[i] = first[i] == i ? judged(results[i], near_first, truth) : tallies[first[i]];
    tallies[i].intersections = results[i].intersections;
    tallies[i].largest = results[i].largest;
    tallies[i].overflowed = results[i].overflowed;
    empty += results[i].polygon.empty();
    wrong += static_cast<std::size_t>(tallies[i].wrong);
  }
  const Restrictions& number = restrictions(input.planes);
  for (std::size_t o = 0; o < kOrders; ++o) sum.orders[o] += tallies[number[o]];
  ++sum.triangles;
  sum.differs += distinct > 1;
  sum.appears += 0 < empty && empty < results.size();
  sum.wrong_in_some += wrong > 0;
  sum.wrong_in_all += wrong == results.size();
  const double near_last_px = tallies[restricted(near_last_order(), input.planes)].moved_px;
  if (near_last_px > sum.near_last_px) {
    sum.near_last_px = near_last_px;
    sum.farthest = index;
  }
}

void merge(const RoundedOrders& part, RoundedOrders& whole) {
  for (std::size_t o = 0; o < kOrders; ++o) whole.orders[o] += part.orders[o];
  whole.triangles += part.triangles;
  whole.differs += part.differs;
  whole.appears += part.appears;
  whole.wrong_in_some += part.wrong_in_some;
  whole.wrong_in_all += part.wrong_in_all;
  if (part.near_last_px > whole.near_last_px) {
    whole.near_last_px = part.near_last_px;
    whole.farthest = part.farthest;
  }
}

// ---- Exact arithmetic ---------------------------------------------------------------------------

using ExactPoints = std::vector<std::array<Exact, 4>>;

// The distinct vertices, sorted; none if fewer than three, which enclose nothing.
void normalise(ExactPoints& points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) points.clear();
}

ExactPoints points_of(const NdcPolygon<Exact, 0>& polygon) {
  ExactPoints points;
  for (const auto& v : polygon) {
    points.push_back({v.position[0], v.position[1], v.position[2], v.position[3]});
  }
  normalise(points);
  return points;
}

ExactPoints points_of(const reference::ExactPolygon& polygon) {
  ExactPoints points;
  for (const auto& v : reference::vertex_set(polygon)) points.push_back({v.x, v.y, v.z, v.inv_w});
  normalise(points);
  return points;
}

// Whether the points, sorted or not, lie off one line on the screen.
bool has_area(const ExactPoints& points) {
  for (std::size_t i = 2; i < points.size(); ++i) {
    const auto &a = points[0], &b = points[1], &c = points[i];
    const Exact left = (b[0] - a[0]) * (c[1] - a[1]);
    const Exact right = (b[1] - a[1]) * (c[0] - a[0]);
    if (left != right) return true;
  }
  return false;
}

ClipTriangle<Exact, 0> exact_triangle(const ClipTriangle<float, K>& triangle) {
  ClipTriangle<Exact, 0> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (int c = 0; c < 4; ++c) result[i].position[c] = Exact(triangle[i].position[c]);
  }
  return result;
}

ExactOrders exact_orders(const TriangleSet& set, const CutTriangle& input,
                         const reference::Truth& truth) {
  const auto results =
      OrderTree<Exact, 0>::cut_all(set.depth, input.planes, exact_triangle(input.triangle));
  ExactOrders tally;
  tally.triangles = 1;
  tally.runs = static_cast<std::int64_t>(results.size());
  tally.mixed_w = std::any_of(input.triangle.begin(), input.triangle.end(),
                              [](const auto& v) { return v.position[3] <= 0; });
  reference::InputTriangle triangle = reference::input_triangle(input.triangle);
  triangle.attribute_count = 0;
  const ExactPoints right = points_of(reference::clip(truth, triangle));
  const ExactPoints first = points_of(results.front().polygon);
  for (const auto& result : results) {
    const ExactPoints points = points_of(result.polygon);
    const bool area = has_area(points) || has_area(first) || has_area(right);
    if (points != first) {
      tally.differs = 1;
      tally.differs_in_area |= area;
    }
    tally.wrong |= area && points != right;
  }
  return tally;
}

}  // namespace

const Order& near_first_order() {
  static constexpr Order kOrder = kPlaneOrder<PlaneOrder::near_first>;
  return kOrder;
}

const Order& near_last_order() {
  static constexpr Order kOrder = kPlaneOrder<PlaneOrder::near_last>;
  return kOrder;
}

OrderTally& OrderTally::operator+=(const OrderTally& other) {
  differs += other.differs;
  other_outline += other.other_outline;
  wrong += other.wrong;
  overflowed += other.overflowed;
  intersections += other.intersections;
  largest = std::max(largest, other.largest);
  moved_px = std::max(moved_px, other.moved_px);
  error_px = std::max(error_px, other.error_px);
  return *this;
}

template <class T>
RoundedOrders measure_rounded(const TriangleSet& set) {
  const auto truth = reference::Truth::of_clip(set.depth);
  const std::size_t chunks = (set.triangles.size() + kChunk - 1) / kChunk;
  std::vector<RoundedOrders> parts(chunks);
  tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t c) {
    const std::size_t end = std::min(set.triangles.size(), (c + 1) * kChunk);
    for (std::size_t i = c * kChunk; i < end; ++i) {
      add_triangle<T>(set, i, truth, parts[c]);
    }
  });
  RoundedOrders sum;
  for (const RoundedOrders& part : parts) merge(part, sum);
  return sum;
}

template RoundedOrders measure_rounded<float>(const TriangleSet&);
template RoundedOrders measure_rounded<double>(const TriangleSet&);

ExactOrders measure_exact(const TriangleSet& set, std::size_t limit) {
  const auto truth = reference::Truth::of_clip(set.depth);
  const std::size_t all = set.triangles.size();
  const std::size_t stride = all <= limit ? 1 : (all + limit - 1) / limit;
  std::vector<ExactOrders> parts((all + stride - 1) / stride);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
    parts[i] = exact_orders(set, set.triangles[i * stride], truth);
  });
  ExactOrders sum;
  for (const ExactOrders& part : parts) {
    sum.triangles += part.triangles;
    sum.mixed_w += part.mixed_w;
    sum.differs += part.differs;
    sum.differs_in_area += part.differs_in_area;
    sum.wrong += part.wrong;
    sum.runs += part.runs;
  }
  return sum;
}

}  // namespace clipscope::experiments

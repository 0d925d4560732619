// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/plane_order/measure.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/judge/compare.hpp"
#include "experiments/judge/match.hpp"
#include "experiments/scenes/random.hpp"
#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments::plane_order {
namespace {

constexpr std::size_t kWindow = 256;  // triangles in work at once
constexpr int K = kSceneAttributes;

// The largest distance on screen of a vertex of one from the nearest vertex of the other,
// differences in the polygons' scalar; 0 if either has none.
double distance_px(const PolygonView& a, const PolygonView& b) {
  const Format& format = a.format();
  double largest = 0;
  const auto from = [&](const PolygonView& x, const PolygonView& y) {
    for (const VertexView& p : x) {
      double nearest = HUGE_VAL;
      for (const VertexView& q : y) {
        const ScreenPoint d = screen_point(difference(format, p[0], q[0]).value,
                                           difference(format, p[1], q[1]).value);
        nearest = std::min(nearest, std::hypot(d[0], d[1]));
      }
      largest = std::max(largest, nearest);
    }
  };
  if (a.empty() || b.empty()) return 0;
  from(a, b);
  from(b, a);
  return largest;
}

OrderTally judged(const PolygonView& polygon, const PolygonView& near_first,
                  const TruthPolygon& truth) {
  const Comparison comparison = compare(polygon, truth);
  OrderTally tally;
  tally.differs = !same_cycle(polygon, near_first, Likeness::by_value);
  tally.other_outline = polygon.size() != near_first.size();
  tally.wrong = comparison.visible && is_failure(comparison.outcome);
  tally.moved_px = distance_px(polygon, near_first);
  if (comparison.outcome <= Outcome::visible) tally.error_px = comparison.position_px;
  return tally;
}

// One triangle by each order of the planes that cut it.
template <class T>
std::vector<OrderTally> judge_orders(const CutTriangle& input,
                                     const reference::Truth& truth_of_clip) {
  const auto truth = truth_polygon(truth_of_clip, reference::input_triangle(input.triangle));
  const auto results =
      OrderTree<T, K>::cut_all(truth_of_clip.volume().depth, input.planes, input.triangle);
  Answers polygons(kFormat<T>, 4 + K);
  for (const OrderedCut<T, K>& result : results) add_polygon(result.polygon, polygons);
  const PolygonView near_first = polygons[restricted(kNearFirst, input.planes)];
  std::vector<OrderTally> tallies;
  std::vector<std::size_t> distinct;  // each polygon is judged once
  for (std::size_t i = 0; i < results.size(); ++i) {
    const auto known = std::ranges::find_if(distinct, [&](std::size_t d) {
      return same_cycle(polygons[d], polygons[i], Likeness::by_value);
    });
    if (known == distinct.end()) {
      distinct.push_back(i);
      tallies.push_back(judged(polygons[i], near_first, truth));
    } else {
      tallies.push_back(tallies[*known]);
    }
    tallies[i].intersections = results[i].intersections;
    tallies[i].largest = results[i].largest;
    tallies[i].overflowed = results[i].overflowed;
  }
  return tallies;
}

void add(const std::vector<OrderTally>& tallies, Outcode planes, std::size_t triangle,
         RoundedOrders& sum) {
  for (std::size_t o = 0; o < kOrders; ++o) {
    sum.orders[o] += tallies[restricted(kAllOrders[o], planes)];
  }
  const auto wrong = std::ranges::count(tallies, 1, &OrderTally::wrong);
  ++sum.triangles;
  sum.differs += std::ranges::count(tallies, 1, &OrderTally::differs) > 0;
  sum.wrong_in_some += wrong > 0;
  sum.wrong_in_all += wrong == std::ssize(tallies);
  const double near_last_px = tallies[restricted(kNearLast, planes)].moved_px;
  if (near_last_px > sum.near_last_px) {
    sum.near_last_px = near_last_px;
    sum.farthest = triangle;
  }
}

// ---- Exact arithmetic ---------------------------------------------------------------------------

using ExactPoints = std::vector<reference::RationalVertex>;

// The distinct points, sorted; none if fewer than three, which enclose nothing.
ExactPoints normalised(ExactPoints points) {
  std::ranges::sort(points, std::less<>());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) points.clear();
  return points;
}

ExactPoints points_of(const NdcPolygon<Exact, 0>& polygon) {
  ExactPoints points;
  for (const auto& [p, none] : polygon) points.push_back({p[0], p[1], p[2], p[3], {}});
  return normalised(std::move(points));
}

// Whether the points, sorted or not, lie off one line on the screen.
bool has_area(const ExactPoints& points) {
  for (std::size_t i = 2; i < points.size(); ++i) {
    const auto &a = points[0], &b = points[1], &c = points[i];
    const Exact left = (b.x - a.x) * (c.y - a.y);
    const Exact right = (b.y - a.y) * (c.x - a.x);
    if (left != right) return true;
  }
  return false;
}

ExactOrders exact_orders(const CutTriangle& input, const reference::Truth& truth) {
  const auto results =
      OrderTree<Exact, 0>::cut_all(truth.volume().depth, input.planes, input.triangle);
  ExactOrders tally{.triangles = 1, .runs = std::ssize(results)};
  tally.mixed_w =
      std::ranges::any_of(input.triangle, [](const auto& v) { return v.position[3] <= 0; });
  reference::InputTriangle triangle = reference::input_triangle(input.triangle);
  triangle.attribute_count = 0;
  const ExactPoints right = normalised(reference::vertex_set(reference::clip(truth, triangle)));
  const ExactPoints first = points_of(results.front().polygon);
  for (const auto& result : results) {
    const ExactPoints points = points_of(result.polygon);
    tally.differs |= points != first;
    tally.wrong |= points != right && (has_area(points) || has_area(first) || has_area(right));
  }
  return tally;
}

// Adds the triangle if some plane cuts it and none rejects it. With all vertices inside nothing
// would depend on an order.
void add_if_cut(const FloatTriangle& triangle, TriangleSet& set) {
  const OutcodeSummary code = summarize_outcodes(ClipVolume{.depth = set.depth}, triangle);
  if (code.all == 0 && code.any != 0) set.triangles.push_back({triangle, code.any});
}

// position(i): four floats. Attributes: barycentric coordinates and 1.
template <class Position>
FloatTriangle triangle_of(const Position& position) {
  FloatTriangle triangle{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array<double, 4> p = position(i);
    triangle[i].position = Vec4<float>(p[0], p[1], p[2], p[3]);
    triangle[i].attributes[static_cast<int>(i)] = triangle[i].attributes[3] = 1;
  }
  return triangle;
}

void add_scene(const Scene& scene, TriangleSet& set) {
  set.depth = scene.views.front().frustum.depth;
  std::vector<SceneTriangle> triangles(scene.mesh.triangles.size());
  for (const View& view : scene.views) {
    view_triangles(scene, view, 0, triangles);
    const Projection<double> projection(frustum_cast<double>(view.frustum));
    for (const SceneTriangle& t : triangles) {
      FloatTriangle clip;
      for (std::size_t i = 0; i < 3; ++i) {
        // Computed in double, each coordinate rounded to float once.
        clip[i] = {Vec4<float>(to_clip(projection, Vec3<double>(t[i].position))), t[i].attributes};
      }
      add_if_cut(clip, set);
    }
  }
}

void add_hard_cases(TriangleSet& set) {
  for (const HardCase& c : builtin_catalogue()) {
    const bool plain = c.volume == ClipVolume{.depth = set.depth};
    if (c.primitive != Primitive::triangle || c.space != Space::clip || !plain) continue;
    add_if_cut(triangle_of([&](std::size_t i) { return c.vertices[i].position; }), set);
  }
}

}  // namespace

OrderTally& OrderTally::operator+=(const OrderTally& other) {
  for (const auto count : {&OrderTally::differs, &OrderTally::other_outline, &OrderTally::wrong,
                           &OrderTally::overflowed, &OrderTally::intersections}) {
    this->*count += other.*count;
  }
  largest = std::max(largest, other.largest);
  moved_px = std::max(moved_px, other.moved_px);
  error_px = std::max(error_px, other.error_px);
  return *this;
}

template <class T>
RoundedOrders measure_rounded(const TriangleSet& set) {
  const auto truth = reference::Truth::of_clip(set.depth);
  RoundedOrders sum{.scalar = kFormat<T>.name};
  for (std::size_t first = 0; first < set.triangles.size(); first += kWindow) {
    std::vector<std::vector<OrderTally>> parts(std::min(kWindow, set.triangles.size() - first));
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
      parts[i] = judge_orders<T>(set.triangles[first + i], truth);
    });
    for (std::size_t i = 0; i < parts.size(); ++i) {
      add(parts[i], set.triangles[first + i].planes, first + i, sum);
    }
  }
  return sum;
}

template RoundedOrders measure_rounded<float>(const TriangleSet&);
template RoundedOrders measure_rounded<double>(const TriangleSet&);

ExactOrders& ExactOrders::operator+=(const ExactOrders& other) {
  triangles += other.triangles;
  mixed_w += other.mixed_w;
  runs += other.runs;
  differs += other.differs;
  wrong += other.wrong;
  return *this;
}

ExactOrders measure_exact(const TriangleSet& set, std::size_t limit) {
  const auto truth = reference::Truth::of_clip(set.depth);
  const std::vector<CutTriangle> triangles = evenly_spaced(set.triangles, limit);
  std::vector<ExactOrders> parts(triangles.size());
  tbb::parallel_for(std::size_t{0}, parts.size(),
                    [&](std::size_t i) { parts[i] = exact_orders(triangles[i], truth); });
  ExactOrders sum;
  for (const ExactOrders& part : parts) sum += part;
  return sum;
}

std::vector<std::string> set_names(const Selection& selection) {
  std::vector<std::string> names =
      selection.scenes_or({"soup_straddling", "soup_behind", "slivers", "floor", "corridor"});
  names.insert(names.end(), {"mixed_w", "lattice", "hard_cases"});
  return names;
}

TriangleSet make_set(const Selection& selection, const std::string& name, std::size_t limit) {
  TriangleSet set{name, DepthRange::minus_one_to_one, {}};
  Random random(selection.seed);
  const auto add_random = [&](const auto& next) {
    while (set.triangles.size() < limit) {
      add_if_cut(triangle_of([&](std::size_t) {
                   return std::array<double, 4>{next(), next(), next(), next()};
                 }),
                 set);
    }
  };
  if (name == "mixed_w") {
    add_random([&] { return random.uniform(-2, 2); });
  } else if (name == "lattice") {
    add_random([&] { return static_cast<double>(random.below(5)) - 2; });
  } else if (name == "hard_cases") {
    add_hard_cases(set);
  } else {
    add_scene(load_selected_scene(selection, name), set);
  }
  set.triangles = evenly_spaced(set.triangles, limit);
  return set;
}

}  // namespace clipscope::experiments::plane_order

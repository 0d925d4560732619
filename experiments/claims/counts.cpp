// SPDX-License-Identifier: GPL-3.0-or-later
//
// What claims of geometry are decided by: how many of so many exact cases are against them.
//
// All is in rational numbers made from the bits of random input, against the exact reference: a
// count of 0 is evidence, any other count holds counterexamples.
#include "experiments/claims/rows.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "experiments/claims/random_cases.hpp"
#include "experiments/judge/compare.hpp"
#include "experiments/scenes/triangulate.hpp"
#include "experiments/selection/select.hpp"
#include "reference/exact_clip.hpp"
#include "spaces/homogeneous/polygon.hpp"
#include "spaces/plane_segment.hpp"

namespace clipscope::experiments::claims {
namespace {

using reference::InputTriangle;
using reference::InputVertex;
using reference::Truth;

using Rows = std::span<CountRow>;

// Is a point of the frustum one with -w <= x, y, z <= w?
void count_inside_tests(Random& random, Rows by_depth) {
  constexpr std::array kDepthRanges = {DepthRange::minus_one_to_one, DepthRange::zero_to_one,
                                       DepthRange::reversed};
  Frustum<double> frustum = random_frustum(random);
  const InputVertex v = lattice_view_vertex(random);
  for (std::size_t d = 0; d < kDepthRanges.size(); ++d) {
    frustum.depth = kDepthRanges[d];
    const Truth truth = Truth::of_frustum(frustum);
    const auto p = truth.clip_position(v);
    const bool claimed = std::all_of(p.begin(), p.begin() + 3,
                                     [&](const Exact& c) { return -p[3] <= c && c <= p[3]; });
    const auto verdict = reference::classify(truth, std::span(&v, 1), 0);
    by_depth[d].add(claimed != (verdict == reference::Verdict::accepted));
  }
}

// Twice the area of a triangle on the screen, by its sign: -1, 0 or 1.
template <class V>
int turn(const V& a, const V& b, const V& c) {
  const Exact area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  return static_cast<int>(CGAL::sign(area));
}

// The sign of det (x y w) of three clip-space vertices: the winding of what is in front of the eye.
int winding(const InputTriangle& t) {
  std::array<std::array<Exact, 4>, 3> p;
  for (std::size_t v = 0; v < 3; ++v) {
    for (std::size_t i = 0; i < 4; ++i) p[v][i] = Exact(t.vertices[v].position[i]);
  }
  const auto& [a, b, c] = p;
  const Exact det = a[0] * (b[1] * c[3] - c[1] * b[3]) - a[1] * (b[0] * c[3] - c[0] * b[3]) +
                    a[3] * (b[0] * c[1] - c[0] * b[1]);
  return static_cast<int>(CGAL::sign(det));
}

// What a clipper leaves of a triangle in exact arithmetic. where: a batch without its numbers.
Answers clip_exactly(std::string_view clipper, Batch where, const InputTriangle& triangle) {
  std::vector<double> numbers;
  for (const InputVertex& v : triangle.vertices) {
    numbers.insert(numbers.end(), v.position.begin(), v.position.begin() + where.dimension());
  }
  where.numbers = std::span<const double>(numbers);
  return clip(find_contestant(clipper, "exact"), where);
}

// Fan triangles of the clipped polygon that are wound against the triangle.
void count_fans(Random& random, Rows by_clipper) {
  const InputTriangle triangle = lattice_clip_triangle(random);
  if (winding(triangle) == 0) return;
  for (std::size_t c = 0; c < 2; ++c) {
    const char* clipper = c == 0 ? "homogeneous/sutherland_hodgman" : "cvv/naive";
    const Answers answers = clip_exactly(clipper, {.space = Space::clip}, triangle);
    std::vector<std::array<Exact, 2>> polygon;
    for (const VertexView v : answers[0]) polygon.push_back({to_exact(v[0]), to_exact(v[1])});
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      const int fan = turn(polygon[0], polygon[i - 1], polygon[i]);
      if (fan != 0) by_clipper[c].add(fan != winding(triangle));
    }
  }
}

// One vertex is outside one plane, the others are inside: four are left, fewer, or anything else.
void count_one_outside(Random& random, Rows left) {
  const Truth truth = Truth::of_clip(DepthRange::minus_one_to_one);
  const InputTriangle t = one_vertex_outside(random);
  if (winding(t) == 0) return;  // seen edge on
  const std::size_t vertices = reference::clip(truth, t).vertices.size();
  const int axis = outside_axis(t.vertices[0]);
  const bool touches = std::any_of(t.vertices.begin() + 1, t.vertices.end(), [&](const auto& v) {
    return v.position[axis] == std::copysign(v.position[3], t.vertices[0].position[axis]);
  });
  const bool four = vertices == 4, fewer = vertices < 4 && touches;
  left[0].add(four);
  left[1].add(fewer);
  left[2].add(!four && !fewer);
}

ViewSegment<Exact, 1> exact_segment(const std::array<InputVertex, 2>& ends) {
  ViewSegment<Exact, 1> segment;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& [x, y, z, one] = ends[i].position;
    segment[i].position = Vec3<Exact>(Exact(x), Exact(y), Exact(z));
    segment[i].attributes[0] = Exact(ends[i].attributes[0]);
  }
  return segment;
}

enum class Of { parameter, attribute };

// The cut of an edge of which the first end is inside the frustum and the second outside of one
// plane alone: is the parameter, is the attribute found with it another in clip space and after the
// divide?
template <Of kOf>
void count_cut(Random& random, Rows by_space) {
  const Frustum<double> frustum = random_frustum(random);
  std::array<InputVertex, 2> ends;
  std::array<Outcode, 2> outside;
  for (std::size_t i = 0; i < 2; ++i) {
    ends[i] = lattice_view_vertex(random);
    ends[i].attributes[0] = static_cast<double>(random.below(17)) - 8;
    const auto& [x, y, z, one] = ends[i].position;
    outside[i] = view_outcode(frustum, Vec3<double>(x, y, z));
  }
  if (outside[0] != 0 || !std::has_single_bit(outside[1])) return;
  const auto plane = static_cast<Plane>(std::countr_zero(outside[1]));

  const Projection<Exact> projection(frustum_cast<Exact>(frustum));
  const auto cut_at = [&](const auto& space, const auto& a, const auto& b) {
    return cut_parameter(signed_distance(space, plane, a), signed_distance(space, plane, b));
  };
  const auto view = exact_segment(ends);
  const auto clip = to_clip(projection, view);
  const Exact t_view = cut_at(projection.frustum, view[0], view[1]);
  const Exact t_clip = cut_at(frustum.depth, clip[0], clip[1]);
  const auto truth = reference::clip(Truth::of_frustum(frustum), ends, 1).vertices.back();
  const Exact value = reference::to_rational(truth.attributes[0]);
  const auto count = [&](CountRow& row, const Exact& t, const auto& from, const auto& to) {
    row.add(kOf == Of::parameter ? t != t_view : interpolate(from, to, t).attributes[0] != value);
  };
  count(by_space[0], t_clip, view[0], view[1]);
  if (!(Exact(0) < clip[1].position[3])) return;  // has no picture
  const auto a = to_ndc(clip[0]), b = to_ndc(clip[1]);
  count(by_space[1], cut_at(frustum.depth, a, b), a, b);
}

// Far corners of a frustum that are not on the side plane of normal (-cos, 0, sin) at half the
// vertical angle. Angles are those of whole-number triangles, so that sine and cosine are rational.
void count_side_normals(Random&, Rows by_aspect) {
  for (const auto& [sine, cosine] : {std::pair{3, 5}, {4, 5}, {5, 13}, {12, 13}, {8, 17}}) {
    const int adjacent = static_cast<int>(std::lround(std::sqrt(cosine * cosine - sine * sine)));
    const Exact s = Exact(sine) / Exact(cosine), c = Exact(adjacent) / Exact(cosine);
    for (const auto& [width, height] : {std::pair{1, 1}, {4, 3}, {16, 9}, {9, 16}, {21, 9}}) {
      const Exact depth = 10, x = s / c * Exact(width) / Exact(height) * depth;
      by_aspect[width == height ? 0 : 1].add(s * depth - c * x != Exact(0));
    }
  }
}

// Whether every edge is a support line of the polygon in x and y.
template <class Polygon>
bool is_convex(const Polygon& polygon) {
  const int n = static_cast<int>(polygon.size());
  bool left = false, right = false;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const int side =
          turn(polygon[i].position, polygon[(i + 1) % n].position, polygon[j].position);
      left = left || side > 0;
      right = right || side < 0;
    }
  }
  return !(left && right);
}

// How many polygons a simple one leaves. Its triangles hang together as a tree does, so that every
// two pieces with an edge in common make one part less.
std::size_t parts_left(const std::vector<std::array<double, 3>>& star) {
  const Truth truth = Truth::of_clip(DepthRange::minus_one_to_one);
  std::vector<std::vector<reference::RationalVertex>> pieces;
  std::size_t joints = 0;
  for (const IndexTriangle& t : triangulate(std::span<const std::array<double, 3>>(star))) {
    InputTriangle triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& [x, y, z] = star[static_cast<std::size_t>(t[i])];
      triangle.vertices[i].position = {x, y, z, 1};
    }
    const auto polygon = reference::clip(truth, triangle);
    if (polygon.vertices.size() < 3) continue;
    const auto piece = reference::vertex_set(polygon);
    for (const auto& other : pieces) {
      std::vector<reference::RationalVertex> shared;
      std::set_intersection(piece.begin(), piece.end(), other.begin(), other.end(),
                            std::back_inserter(shared));
      joints += shared.size() >= 2;
    }
    pieces.push_back(piece);
  }
  return pieces.size() - joints;
}

// A convex polygon that leaves something not convex, and a concave one that leaves several.
void count_parts(Random& random, Rows counts) {
  HomogeneousPolygonClipper<Exact, 0> clipper;
  const auto left = clipper(ClipVolume{}, convex_clip_polygon(random));
  if (!left.empty()) counts[0].add(!is_convex(left));
  const std::size_t parts = parts_left(star_polygon(random));
  if (parts > 0) counts[1].add(parts > 1);
}

// In float, over all exponents: the denominator of t on edges that cross a plane, 0 or infinite.
void count_denominators(Random& random, Rows counts) {
  const auto any_float = [&random] {
    float value = NAN;
    while (!std::isfinite(value)) {
      value = std::bit_cast<float>(static_cast<std::uint32_t>(random.below(1ULL << 32)));
    }
    return value;
  };
  const float x0 = any_float(), w0 = any_float(), x1 = any_float(), w1 = any_float();
  const float kept = w0 + x0, cut = w1 + x1;
  if (!(kept > 0 && cut < 0) || std::isinf(kept) || std::isinf(cut)) return;
  counts[0].add(kept - cut == 0);
  counts[1].add(std::isinf(kept - cut));
}

// 9 vertices, and more: of triangles around the volume's hexagon and of any in turn.
void count_vertices(Random& random, Rows counts) {
  const bool around = counts[0].cases % 2 == 0;
  const InputTriangle t = around ? hexagon_cutter(random) : lattice_clip_triangle(random);
  const Truth truth = Truth::of_clip(DepthRange::minus_one_to_one);
  const std::size_t vertices = reference::clip(truth, t).vertices.size();
  counts[0].add(vertices == 9);
  counts[1].add(vertices > 9);
}

// Each space in exact arithmetic against the reference.
void count_spaces(Random& random, Rows by_clipper) {
  constexpr std::array kClippers = {"view/sutherland_hodgman", "homogeneous/sutherland_hodgman",
                                    "cvv/near_first"};
  const Frustum<double> frustum = random_frustum(random);
  const InputTriangle t = lattice_view_triangle(random);
  const TruthPolygon truth = truth_polygon(Truth::of_frustum(frustum), t);
  for (std::size_t c = 0; c < kClippers.size(); ++c) {
    const Answers answers =
        clip_exactly(kClippers[c], {.frustum = frustum, .volume = {.depth = frustum.depth}}, t);
    const Comparison comparison = compare(answers[0], truth);
    if (comparison.visible) by_clipper[c].add(comparison.outcome != Outcome::exact);
  }
}

// (1, 1, 0) seen with l = b = -1, r = t = 1, n = 1, f = 10.
void count_example(Random&, Rows counts) {
  const Truth truth = Truth::of_frustum({.near = 1, .far = 10});
  const auto p = truth.clip_position({.position = {1, 1, 0, 1}});
  counts[0].add(p[0] == 1 && p[1] == 1 && p[2] == Exact(-20) / Exact(9) && p[3] == 0);
}

}  // namespace

std::vector<CountingTask> counting_tasks() {
  using Count = void (*)(Random&, Rows);
  std::vector<CountingTask> tasks;
  const auto add = [&](int claim, std::string_view title, Count count, std::size_t times,
                       const std::vector<std::string_view>& quantities) {
    tasks.push_back({claim, title, count, times, quantities});
  };
  add(5, "points of the frustum against -w <= x, y, z <= w", count_inside_tests, 1,
      {"disagrees, depth [-1, 1]", "disagrees, depth [0, 1]", "disagrees, depth reversed"});
  add(6, "winding of the fan", count_fans, 1,
      {"fan triangles wound the other way, cut in clip space",
       "fan triangles wound the other way, divided first"});
  add(8, "one vertex outside one plane", count_one_outside, 1,
      {"leaves 4 vertices", "leaves fewer: another vertex is on the plane",
       "leaves anything else"});
  add(9, "attributes at t", count_cut<Of::attribute>, 20,
      {"attribute at t in clip space is wrong", "attribute at t after the divide is wrong"});
  add(10, "normals of the side planes", count_side_normals, 0,
      {"corners off the plane, aspect 1", "corners off the plane, aspect not 1"});
  add(16, "parts of convex and concave polygons", count_parts, 1,
      {"a convex polygon leaves one that is not", "a concave polygon leaves several"});
  add(24, "t in three spaces", count_cut<Of::parameter>, 20,
      {"t in clip space is not t in view space", "t after the divide is not t in view space"});
  add(25, "denominator of t, float, all exponents", count_denominators, 100,
      {"denominator 0", "denominator overflows"});
  add(26, "number of vertices", count_vertices, 1, {"9 vertices", "more than 9 vertices"});
  add(27, "each space in exact arithmetic against the reference", count_spaces, 1,
      {"view space differs", "clip space differs", "the CVV differs"});
  add(28, "the point (1, 1, 0) in clip space", count_example, 0,
      {"clip coordinates are (1, 1, -20/9, 0)"});
  return tasks;
}

std::vector<CountRow> count_cases(const CountingTask& task, std::uint64_t seed, std::size_t size) {
  std::vector<CountRow> rows;
  for (const std::string_view quantity : task.quantities) {
    rows.push_back({task.claim, std::string(task.title), std::string(quantity)});
  }
  Random random(seed);
  const std::size_t inputs = task.times == 0 ? 1 : task.times * size;
  for (std::size_t i = 0; i < inputs; ++i) task.count(random, rows);
  return rows;
}

}  // namespace clipscope::experiments::claims

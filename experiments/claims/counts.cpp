// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/claims/counts.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <optional>

#include "experiments/claims/random_cases.hpp"
#include "experiments/contestants/contestant.hpp"
#include "experiments/measure/compare.hpp"
#include "experiments/primitives/triangulate.hpp"
#include "reference/exact_clip.hpp"
#include "spaces/homogeneous/polygon.hpp"
#include "spaces/plane_segment.hpp"

namespace clipscope::experiments {
namespace {

using reference::InputTriangle;
using reference::InputVertex;
using reference::Truth;

constexpr std::array kDepthRanges = {DepthRange::minus_one_to_one, DepthRange::zero_to_one,
                                     DepthRange::reversed};

bool is_inside(const Truth& truth, const InputVertex& v) {
  return reference::classify(truth, std::span(&v, 1), 0) == reference::Verdict::accepted;
}

// Claim 5: is a point of the frustum one with -w <= x, y, z <= w?
std::vector<ExactCount> count_inside_tests(std::uint64_t seed, std::size_t size) {
  Random random(seed);
  std::vector<ExactCount> counts = {
      {"disagrees, depth [-1, 1]"}, {"disagrees, depth [0, 1]"}, {"disagrees, depth reversed"}};
  for (std::size_t i = 0; i < size; ++i) {
    Frustum<double> frustum = random_frustum(random);
    const InputVertex v = lattice_view_vertex(random);
    for (std::size_t d = 0; d < kDepthRanges.size(); ++d) {
      frustum.depth = kDepthRanges[d];
      const Truth truth = Truth::of_frustum(frustum);
      const auto p = truth.clip_position(v);
      const bool claimed = std::all_of(p.begin(), p.begin() + 3,
                                       [&](const Exact& c) { return -p[3] <= c && c <= p[3]; });
      ++counts[d].cases;
      counts[d].count += claimed != is_inside(truth, v);
    }
  }
  return counts;
}

// Twice the area of an NDC triangle, by its sign: -1, 0 or 1.
template <class V>
int turn(const V& a, const V& b, const V& c) {
  const Exact area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  return static_cast<int>(CGAL::sign(area));
}

// The sign of det (x y w) of three clip-space vertices: the winding of what is in front of the eye.
int winding(const ClipTriangle<Exact, kRunTime>& t) {
  const auto &a = t[0].position, &b = t[1].position, &c = t[2].position;
  const Exact det = a[0] * (b[1] * c[3] - c[1] * b[3]) - a[1] * (b[0] * c[3] - c[0] * b[3]) +
                    a[3] * (b[0] * c[1] - c[0] * b[1]);
  return static_cast<int>(CGAL::sign(det));
}

const Contestant<Exact>& exact_contestant(std::string_view clipper) {
  return *std::get<const Contestant<Exact>*>(find_contestant(clipper, "exact"));
}

// Claim 6: fan triangles of the clipped polygon that are wound against the triangle.
void count_windings(const Contestant<Exact>& contestant, const ClipTriangle<Exact, kRunTime>& t,
                    ExactCount& against) {
  NdcPolygon<Exact, kRunTime> polygon;
  contestant.clip_one(ClipVolume{}, t, polygon);
  for (int i = 2; i < polygon.size(); ++i) {
    const int fan = turn(polygon[0].position, polygon[i - 1].position, polygon[i].position);
    if (fan == 0) continue;
    ++against.cases;
    against.count += fan != winding(t);
  }
}

std::vector<ExactCount> count_fans(std::uint64_t seed, std::size_t size) {
  Random random(seed);
  ExactCount in_order{"fan triangles wound the other way, cut in clip space"};
  ExactCount naive{"fan triangles wound the other way, divided first"};
  for (std::size_t i = 0; i < size; ++i) {
    const auto triangle = exact_clip_triangle(lattice_clip_triangle(random));
    if (winding(triangle) == 0) continue;
    count_windings(exact_contestant("homogeneous/sutherland_hodgman"), triangle, in_order);
    count_windings(exact_contestant("cvv/naive"), triangle, naive);
  }
  return {in_order, naive};
}

// Claim 8: one vertex outside one plane, the others inside.
std::vector<ExactCount> count_one_outside(std::uint64_t seed, std::size_t size) {
  Random random(seed);
  ExactCount four{"leaves 4 vertices"}, touching{"leaves fewer: another vertex is on the plane"},
      other{"leaves anything else"};
  const Truth truth = Truth::of_clip(DepthRange::minus_one_to_one);
  for (std::size_t i = 0; i < size; ++i) {
    const InputTriangle t = one_vertex_outside(random);
    if (winding(exact_clip_triangle(t)) == 0) continue;  // seen edge on
    const std::size_t vertices = reference::clip(truth, t).vertices.size();
    const int axis = outside_axis(t.vertices[0]);
    const bool touches = std::any_of(t.vertices.begin() + 1, t.vertices.end(), [&](const auto& v) {
      return v.position[axis] == std::copysign(v.position[3], t.vertices[0].position[axis]);
    });
    for (ExactCount* c : {&four, &touching, &other}) ++c->cases;
    ExactCount& kind = vertices == 4 ? four : vertices < 4 && touches ? touching : other;
    ++kind.count;
  }
  return {four, touching, other};
}

// An edge of which the first end is inside the frustum and the second outside of `plane` alone.
struct CrossingEdge {
  Frustum<double> frustum;
  Plane plane;
  std::array<InputVertex, 2> ends;
};

std::optional<CrossingEdge> random_crossing_edge(Random& random) {
  CrossingEdge edge{random_frustum(random), Plane::left, {}};
  for (InputVertex& end : edge.ends) {
    end = lattice_view_vertex(random);
    end.attributes[0] = static_cast<double>(random.below(17)) - 8;
  }
  const auto code = [&](const InputVertex& v) {
    return view_outcode(edge.frustum, Vec3<double>(v.position[0], v.position[1], v.position[2]));
  };
  const Outcode outside = code(edge.ends[1]);
  if (code(edge.ends[0]) != 0 || !std::has_single_bit(outside)) return std::nullopt;
  edge.plane = static_cast<Plane>(std::countr_zero(outside));
  return edge;
}

// Claims 9 and 24: the parameter of the cut in each space, and the attribute found with it.
struct EdgeCounts {
  ExactCount clip_t, ndc_t, clip_attribute, ndc_attribute;

  void add(const CrossingEdge& edge) {
    const Projection<Exact> projection(exact_frustum(edge.frustum));
    const auto view = exact_view_segment(edge.ends);
    const auto clip = to_clip(projection, view);
    const auto& f = projection.frustum;
    const Exact t_view = cut_parameter(signed_distance(f, edge.plane, view[0]),
                                       signed_distance(f, edge.plane, view[1]));
    const Exact t_clip = cut_parameter(signed_distance(f.depth, edge.plane, clip[0]),
                                       signed_distance(f.depth, edge.plane, clip[1]));
    const auto cut = reference::clip(Truth::of_frustum(edge.frustum), edge.ends, 1);
    const Exact truth = reference::to_rational(cut.vertices.back().attributes[0]);
    note(clip_t, t_clip != t_view);
    note(clip_attribute, interpolate(view[0], view[1], t_clip).attributes[0] != truth);
    if (!(Exact(0) < clip[1].position[3])) return;  // has no picture
    const auto a = to_ndc(clip[0]), b = to_ndc(clip[1]);
    const Exact t_ndc = cut_parameter(signed_distance(f.depth, edge.plane, a),
                                      signed_distance(f.depth, edge.plane, b));
    note(ndc_t, t_ndc != t_view);
    note(ndc_attribute, interpolate(a, b, t_ndc).attributes[0] != truth);
  }

 private:
  static void note(ExactCount& c, bool differs) {
    ++c.cases;
    c.count += differs;
  }
};

EdgeCounts count_edges(std::uint64_t seed, std::size_t size) {
  Random random(seed);
  EdgeCounts counts{{"t in clip space is not t in view space"},
                    {"t after the divide is not t in view space"},
                    {"attribute at t in clip space is wrong"},
                    {"attribute at t after the divide is wrong"}};
  for (std::size_t i = 0; i < 20 * size; ++i) {
    if (const auto edge = random_crossing_edge(random)) counts.add(*edge);
  }
  return counts;
}

std::vector<ExactCount> count_attributes(std::uint64_t seed, std::size_t size) {
  const EdgeCounts counts = count_edges(seed, size);
  return {counts.clip_attribute, counts.ndc_attribute};
}

std::vector<ExactCount> count_parameters(std::uint64_t seed, std::size_t size) {
  const EdgeCounts counts = count_edges(seed, size);
  return {counts.clip_t, counts.ndc_t};
}

// Claim 10: far corners of a frustum that are not on the side plane of normal (-cos, 0, sin) at half
// the vertical angle. Angles of whole-number triangles, so that sine and cosine are rational.
std::vector<ExactCount> count_side_normals(std::uint64_t, std::size_t) {
  ExactCount square{"corners off the plane, aspect 1"}, wide{"corners off the plane, aspect not 1"};
  for (const auto& [sine, cosine] : {std::pair{3, 5}, {4, 5}, {5, 13}, {12, 13}, {8, 17}}) {
    const int adjacent = static_cast<int>(std::lround(std::sqrt(cosine * cosine - sine * sine)));
    const Exact s = Exact(sine) / Exact(cosine), c = Exact(adjacent) / Exact(cosine);
    for (const auto& [width, height] : {std::pair{1, 1}, {4, 3}, {16, 9}, {9, 16}, {21, 9}}) {
      const Exact depth = 10, x = s / c * Exact(width) / Exact(height) * depth;
      ExactCount& kind = width == height ? square : wide;
      ++kind.cases;
      kind.count += s * depth - c * x != Exact(0);
    }
  }
  return {square, wide};
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

// Pieces that share two vertices belong together: how many there are.
std::size_t connected_parts(const std::vector<std::vector<reference::RationalVertex>>& pieces) {
  std::vector<std::size_t> part(pieces.size());
  std::iota(part.begin(), part.end(), 0);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      std::vector<reference::RationalVertex> shared;
      std::set_intersection(pieces[i].begin(), pieces[i].end(), pieces[j].begin(), pieces[j].end(),
                            std::back_inserter(shared));
      if (shared.size() >= 2) std::replace(part.begin(), part.end(), part[i], part[j]);
    }
  }
  std::sort(part.begin(), part.end());
  return static_cast<std::size_t>(std::unique(part.begin(), part.end()) - part.begin());
}

std::size_t parts_left(const std::vector<std::array<double, 3>>& star) {
  const Truth truth = Truth::of_clip(DepthRange::minus_one_to_one);
  std::vector<std::vector<reference::RationalVertex>> pieces;
  for (const IndexTriangle& t : triangulate(std::span<const std::array<double, 3>>(star))) {
    InputTriangle triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& p = star[static_cast<std::size_t>(t[i])];
      triangle.vertices[i].position = {p[0], p[1], p[2], 1};
    }
    const auto polygon = reference::clip(truth, triangle);
    if (polygon.vertices.size() >= 3) pieces.push_back(reference::vertex_set(polygon));
  }
  return connected_parts(pieces);
}

// Claim 16.
std::vector<ExactCount> count_parts(std::uint64_t seed, std::size_t size) {
  Random random(seed);
  ExactCount not_convex{"a convex polygon leaves one that is not"};
  ExactCount several{"a concave polygon leaves several"};
  HomogeneousPolygonClipper<Exact, 0> clipper;
  for (std::size_t i = 0; i < size; ++i) {
    const auto left = clipper(ClipVolume{}, convex_clip_polygon(random));
    if (!left.empty()) {
      ++not_convex.cases;
      not_convex.count += !is_convex(left);
    }
    const std::size_t parts = parts_left(star_polygon(random));
    several.cases += parts > 0;
    several.count += parts > 1;
  }
  return {not_convex, several};
}

// Claim 25, in float, over all exponents: the denominator of t on edges that cross a plane.
std::vector<ExactCount> count_denominators(std::uint64_t seed, std::size_t size) {
  Random random(seed);
  ExactCount zero{"denominator 0"}, infinite{"denominator overflows"};
  const auto any_float = [&random] {
    float value = NAN;
    while (!std::isfinite(value)) {
      value = std::bit_cast<float>(static_cast<std::uint32_t>(random.below(1ULL << 32)));
    }
    return value;
  };
  for (std::size_t i = 0; i < 100 * size; ++i) {
    const float x0 = any_float(), w0 = any_float(), x1 = any_float(), w1 = any_float();
    const float kept = w0 + x0, cut = w1 + x1;
    if (!(kept > 0 && cut < 0) || std::isinf(kept) || std::isinf(cut)) continue;
    const float length = kept - cut;
    for (ExactCount* c : {&zero, &infinite}) ++c->cases;
    zero.count += length == 0;
    infinite.count += std::isinf(length);
  }
  return {zero, infinite};
}

// Claim 26.
std::vector<ExactCount> count_vertices(std::uint64_t seed, std::size_t size) {
  Random random(seed);
  ExactCount nine{"9 vertices"}, more{"more than 9 vertices"};
  const Truth truth = Truth::of_clip(DepthRange::minus_one_to_one);
  for (std::size_t i = 0; i < size; ++i) {
    const InputTriangle t = i % 2 == 0 ? hexagon_cutter(random) : lattice_clip_triangle(random);
    const std::size_t vertices = reference::clip(truth, t).vertices.size();
    for (ExactCount* c : {&nine, &more}) ++c->cases;
    nine.count += vertices == 9;
    more.count += vertices > 9;
  }
  return {nine, more};
}

// Claims 12 and 27: each space in exact arithmetic against the reference.
std::vector<ExactCount> count_spaces(std::uint64_t seed, std::size_t size) {
  constexpr std::array<std::string_view, 3> kClippers = {
      "view/sutherland_hodgman", "homogeneous/sutherland_hodgman", "cvv/near_first"};
  Random random(seed);
  std::vector<ExactCount> counts;
  for (const auto name : kClippers) counts.push_back({std::string(name) + " differs"});
  for (std::size_t i = 0; i < size; ++i) {
    const Frustum<double> frustum = random_frustum(random);
    const InputTriangle t = lattice_view_triangle(random);
    const TruthPolygon truth = truth_polygon(Truth::of_frustum(frustum), t);
    for (std::size_t c = 0; c < kClippers.size(); ++c) {
      NdcPolygon<Exact, kRunTime> polygon;
      exact_contestant(kClippers[c])
          .view_one(Projection<Exact>(exact_frustum(frustum)), exact_view_triangle(t), polygon);
      const auto result =
          compare<Exact, kRunTime>(std::span(polygon.begin(), polygon.end()), truth);
      counts[c].cases += result.visible;
      counts[c].count += result.visible && result.outcome != Outcome::exact;
    }
  }
  return counts;
}

// Claim 28: (1, 1, 0) seen with l = b = -1, r = t = 1, n = 1, f = 10.
std::vector<ExactCount> count_example(std::uint64_t, std::size_t) {
  const Truth truth = Truth::of_frustum({.near = 1, .far = 10});
  const auto p = truth.clip_position({.position = {1, 1, 0, 1}});
  const bool as_claimed = p[0] == 1 && p[1] == 1 && p[2] == Exact(-20) / Exact(9) && p[3] == 0;
  return {{"clip coordinates are (1, 1, -20/9, 0)", 1, as_claimed}};
}

}  // namespace

const std::vector<CountingTask>& counting_tasks() {
  static const std::vector<CountingTask> all = {
      {5, "points of the frustum against -w <= x, y, z <= w", count_inside_tests},
      {6, "winding of the fan", count_fans},
      {8, "one vertex outside one plane", count_one_outside},
      {9, "attributes at t", count_attributes},
      {10, "normals of the side planes", count_side_normals},
      {16, "parts of convex and concave polygons", count_parts},
      {24, "t in three spaces", count_parameters},
      {25, "denominator of t, float, all exponents", count_denominators},
      {26, "number of vertices", count_vertices},
      {27, "each space in exact arithmetic against the reference", count_spaces},
      {28, "the point (1, 1, 0) in clip space", count_example}};
  return all;
}

}  // namespace clipscope::experiments

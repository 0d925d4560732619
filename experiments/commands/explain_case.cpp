// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/commands/explain_case.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <span>
#include <utility>

#include "experiments/contestants/contestant.hpp"
#include "experiments/errors.hpp"
#include "experiments/hard_cases/case_input.hpp"
#include "experiments/hard_cases/judge.hpp"
#include "experiments/measure/compare.hpp"
#include "experiments/report/decimal.hpp"
#include "experiments/report/outcode_text.hpp"
#include "spaces/cut.hpp"
#include "spaces/homogeneous/polygon.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::string_view kPolygonClipper = "homogeneous/polygon";

// Of a case that was written down as one.
void print_heading(const HardCase& hard_case) {
  if (hard_case.file.empty()) return;
  fmt::print("{}: a {} in {} space\n", hard_case.name, to_string(hard_case.primitive),
             hard_case.space == Space::view ? "view" : "clip");
  fmt::print("  why it is hard: {}\n  where it was met: {}\n", hard_case.why, hard_case.source);
  // What follows in clip space starts with an empty line.
  if (hard_case.space == Space::view) fmt::print("\n");
}

template <class Numbers>
std::string numbers_text(const Numbers& numbers, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += fmt::format(" {:>16.9g}", nearest_double(numbers[i]));
  return text;
}

template <Space S, class T>
void print_polygon(const Polygon<S, T, kRunTime>& polygon) {
  for (int v = 0; v < polygon.size(); ++v) {
    fmt::print("      {}: {}\n", v, numbers_text(polygon[v].position, Vertex<S, T, 0>::kDimension));
  }
}

// Cuts by each plane of the volume that some vertex is outside of and prints what is left.
template <Space S, class T, class Distance>
void print_cuts(const Triangle<S, T, kRunTime>& triangle, const ClipVolume& volume,
                Distance&& distance) {
  static constexpr std::array kOrder = {Plane::near,  Plane::far,    Plane::left,
                                        Plane::right, Plane::bottom, Plane::top};
  Polygon<S, T, kRunTime> polygon, cut_off;
  polygon.assign(triangle);
  for_each_plane(planes_of(volume), kOrder, [&](Plane plane) {
    const auto d = [&](const Vertex<S, T, kRunTime>& v) { return distance(plane, v); };
    std::string distances;
    bool crossed = false;
    for (int v = 0; v < polygon.size(); ++v) {
      const T value = d(polygon[v]);
      distances += fmt::format(" {:.6g}", nearest_double(value));
      crossed = crossed || !(T(0) <= value);
    }
    if (!crossed) return;
    cut(polygon, cut_off, d);
    fmt::print("    {}: distances{}; {} vertices become {}\n", plane_text(plane), distances,
               polygon.size(), cut_off.size());
    std::swap(polygon, cut_off);
    print_polygon(polygon);
  });
  if (polygon.size() < 3) fmt::print("    nothing is left\n");
}

// A line per vertex: its coordinates and what it is outside of. code(v): the bits of the six planes.
template <class Vertices, class Code>
void print_vertices(const Vertices& vertices, int dimension, const ClipVolume& volume,
                    Code&& code) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto& v = vertices[i];
    const Outcode outside = code(v) | clip_distance_outcode(volume, v.attributes);
    fmt::print("  v{}: {}  {}\n", i, numbers_text(v.position, dimension),
               outcode_text(outside & planes_of(volume)));
  }
}

template <class T, class Vertices>
void print_view_vertices(const Projection<T>& projection, const Vertices& vertices) {
  fmt::print("View space: x y z\n");
  print_vertices(vertices, 3, projection.volume,
                 [&](const auto& v) { return view_outcode(projection.frustum, v.position); });
}

template <class Vertices>
void print_clip_vertices(const ClipVolume& volume, const Vertices& vertices) {
  fmt::print("\nClip space: x y z w\n");
  print_vertices(vertices, 4, volume,
                 [&](const auto& v) { return clip_outcode(volume.depth, v.position); });
}

// Of points, segments and polygons: the same without the cuts.
template <class T>
void print_places(const HardCase& hard_case) {
  const Projection<T> projection = case_projection<T>(hard_case);
  if (hard_case.space == Space::clip) {
    print_clip_vertices(hard_case.volume, case_vertices<T, Space::clip>(hard_case));
    return;
  }
  const auto vertices = case_vertices<T, Space::view>(hard_case);
  print_view_vertices(projection, vertices);
  std::vector<ClipVertex<T, kRunTime>> projected;
  for (const ViewVertex<T, kRunTime>& v : vertices) projected.push_back(to_clip(projection, v));
  print_clip_vertices(hard_case.volume, projected);
}

template <class T>
void explain_view(const Projection<T>& projection, const ViewTriangle<T, kRunTime>& triangle) {
  print_view_vertices(projection, triangle);
  fmt::print("  cuts in view space\n");
  print_cuts<Space::view>(triangle, projection.volume, [&](Plane plane, const auto& v) {
    return signed_distance(projection.frustum, plane, v);
  });
}

template <class T>
void explain_clip(const ClipVolume& volume, const ClipTriangle<T, kRunTime>& triangle) {
  print_clip_vertices(volume, triangle);
  fmt::print("  cuts in clip space\n");
  print_cuts<Space::clip>(triangle, volume, [&](Plane plane, const auto& v) {
    return signed_distance(volume.depth, plane, v);
  });
}

template <class T>
void explain_ndc(const ClipVolume& volume, const ClipTriangle<T, kRunTime>& triangle) {
  fmt::print("\nCanonical view volume, divided before any cut: x y z 1/w\n");
  Triangle<Space::ndc, T, kRunTime> divided;
  for (int v = 0; v < 3; ++v) {
    const T& w = triangle[v].position[3];
    if (!can_divide_by(w)) {
      fmt::print("  v{} has w = 0: it can't be divided\n", v);
      return;
    }
    divided[v] = to_ndc(triangle[v]);
    fmt::print("  v{}: {}  {}{}\n", v, numbers_text(divided[v].position, 4),
               outcode_text(ndc_outcode(volume.depth, divided[v].position) & planes_of(volume)),
               T(0) < w ? "" : "; w <= 0: mirrored through the eye or at infinity");
  }
  fmt::print("  cuts in the volume\n");
  print_cuts<Space::ndc>(divided, volume, [&](Plane plane, const auto& v) {
    return signed_distance(volume.depth, plane, v);
  });
}

// The exact vertex nearest to a vertex of the answer, on the screen.
template <class T>
const reference::ExactVertex& nearest_vertex(const TruthPolygon& truth,
                                             const NdcVertex<T, kRunTime>& v) {
  std::size_t best = 0;
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < truth.approximation.size(); ++i) {
    const auto& a = truth.approximation[i];
    const double distance =
        std::hypot(nearest_double(v.position[0]) - a[0], nearest_double(v.position[1]) - a[1]);
    if (distance < least) {
      least = distance;
      best = i;
    }
  }
  return truth.exact.vertices[best];
}

std::string coordinate_name(int i) {
  static constexpr std::array<const char*, 4> kNames = {"x", "y", "z", "1/w"};
  return i < 4 ? kNames[static_cast<std::size_t>(i)] : fmt::format("a{}", i - 4);
}

// Digits that tell the scalar's numbers apart.
template <class T>
constexpr int digits_of() {
  return ScalarTraits<T>::precision == 0 ? 34 : (ScalarTraits<T>::precision * 302) / 1000 + 3;
}

template <class T>
void print_coordinate(const std::string& name, const T& value, const reference::Fraction& exact) {
  constexpr int kDigits = digits_of<T>();
  if (!is_finite(value)) {
    fmt::print("      {:5}  {} (not finite), exact {}\n", name, nearest_double(value),
               decimal(reference::to_rational(exact), kDigits));
    return;
  }
  const Exact found = to_exact(value);
  const Exact right = reference::to_rational(exact);
  const double error = reference::error_of(found, exact);
  const double ulp = ulp_at<T>(reference::approximate(exact));
  fmt::print("      {:5}  {}\n", name, marked_decimal(found, right, kDigits));
  fmt::print("      exact  {}  error {:.2g}{}\n", decimal(right, kDigits), error,
             ulp > 0 ? fmt::format(" = {:.3g} ulp", std::abs(error) / ulp) : "");
}

template <class T>
void print_beside_exact(const NdcVertex<T, kRunTime>& vertex, const reference::ExactVertex& exact) {
  for (int i = 0; i < 4; ++i) {
    print_coordinate(coordinate_name(i), vertex.position[i], coordinate(exact, i));
  }
  for (int k = 0; k < vertex.attributes.size(); ++k) {
    print_coordinate(coordinate_name(4 + k), vertex.attributes[k], coordinate(exact, 4 + k));
  }
}

// What an empty answer lacks.
template <class T>
void print_exact_vertices(const TruthPolygon& truth) {
  for (std::size_t v = 0; v < truth.exact.vertices.size(); ++v) {
    fmt::print("    exact vertex {}\n", v);
    for (std::size_t i = 0; i < truth.approximation[v].size(); ++i) {
      const auto c = static_cast<int>(i);
      const Exact value = reference::to_rational(coordinate(truth.exact.vertices[v], c));
      fmt::print("      {:5}  {}\n", coordinate_name(c), decimal(value, digits_of<T>()));
    }
  }
}

template <class T>
void print_answer(std::string_view clipper, std::span<const NdcVertex<T, kRunTime>> polygon,
                  const TruthPolygon& truth) {
  fmt::print("\nAnswer of {} in {}\n", clipper, ScalarTraits<T>::name);
  const Comparison comparison = compare<T, kRunTime>(polygon, truth);
  fmt::print("  {} vertices, exact {}; outcome: {}\n", polygon.size(), truth.exact.vertices.size(),
             outcome_name(comparison.outcome));
  if (truth.exact.vertices.empty()) return;
  if (polygon.empty()) {
    print_exact_vertices<T>(truth);
    return;
  }
  fmt::print("  the first wrong digit is in brackets\n");
  for (std::size_t v = 0; v < polygon.size(); ++v) {
    fmt::print("    vertex {}\n", v);
    print_beside_exact(polygon[v], nearest_vertex(truth, polygon[v]));
  }
}

template <class T, std::size_t N>
void check_takes(const Contestant<T, N>& contestant, const HardCase& hard_case) {
  if (hard_case.space == Space::clip && contestant.clip_one == nullptr) {
    throw UsageError(
        fmt::format("--clipper: {} starts in view space, so clip-space {}s are not applicable",
                    contestant.name, to_string(hard_case.primitive)));
  }
  if (!is_applicable(contestant.promise, hard_case.volume)) {
    throw UsageError(
        fmt::format("--clipper: {} does not take depth clamp or clip distances", contestant.name));
  }
}

template <class T, std::size_t N>
void explain_simplex(const Contestant<T, N>& contestant, const HardCase& hard_case) {
  check_takes(contestant, hard_case);
  print_heading(hard_case);
  const auto polygon = std::make_unique<NdcPolygon<T, kRunTime>>();
  if (hard_case.space == Space::view) {
    const Projection<T> projection = case_projection<T>(hard_case);
    const auto simplex = case_simplex<T, Space::view, N>(hard_case);
    if constexpr (N == 3) {
      explain_view(projection, simplex);
      explain_clip(hard_case.volume, to_clip(projection, simplex));
      explain_ndc(hard_case.volume, to_clip(projection, simplex));
    }
    contestant.view_one(projection, simplex, *polygon);
  } else {
    const auto simplex = case_simplex<T, Space::clip, N>(hard_case);
    if constexpr (N == 3) {
      explain_clip(hard_case.volume, simplex);
      explain_ndc(hard_case.volume, simplex);
    }
    contestant.clip_one(hard_case.volume, simplex, *polygon);
  }
  if constexpr (N != 3) print_places<T>(hard_case);
  print_answer<T>(contestant.name, std::span(polygon->begin(), polygon->end()),
                  truth_polygon(hard_case));
}

template <std::size_t N>
std::string explain_simplex(const HardCase& hard_case, std::string_view clipper,
                            std::string_view scalar) {
  const AnyContestantOf<N> chosen = find_contestant<N>(clipper, scalar);
  std::visit([&](const auto* contestant) { explain_simplex(*contestant, hard_case); }, chosen);
  return std::string(clipper_name<N>(chosen));
}

template <class T>
void explain_polygon(const HardCase& hard_case) {
  HomogeneousPolygonClipper<T, kRunTime> clip;
  print_heading(hard_case);
  print_places<T>(hard_case);
  const TruthPolygon truth = truth_polygon(hard_case);
  if (hard_case.space == Space::view) {
    print_answer<T>(kPolygonClipper,
                    clip(case_projection<T>(hard_case), case_vertices<T, Space::view>(hard_case)),
                    truth);
  } else {
    print_answer<T>(kPolygonClipper,
                    clip(hard_case.volume, case_vertices<T, Space::clip>(hard_case)), truth);
  }
}

std::string explain_polygon(const HardCase& hard_case, std::string_view clipper,
                            std::string_view scalar) {
  if (clipper != kPolygonClipper) {
    throw UsageError(fmt::format("--clipper: no clipper of polygons is called '{}'; there is: {}",
                                 clipper, kPolygonClipper));
  }
  // Any clipper that exists in every scalar tells the scalar's type.
  std::visit([&]<class T>(const Contestant<T>*) { explain_polygon<T>(hard_case); },
             find_contestant("homogeneous/sutherland_hodgman", scalar));
  return std::string(clipper);
}

}  // namespace

std::string explain_case(const HardCase& hard_case, std::string_view clipper,
                         std::string_view scalar) {
  switch (hard_case.primitive) {
    case Primitive::point: return explain_simplex<1>(hard_case, clipper, scalar);
    case Primitive::segment: return explain_simplex<2>(hard_case, clipper, scalar);
    case Primitive::triangle: return explain_simplex<3>(hard_case, clipper, scalar);
    case Primitive::polygon: break;
  }
  return explain_polygon(hard_case, clipper, scalar);
}

}  // namespace clipscope::experiments

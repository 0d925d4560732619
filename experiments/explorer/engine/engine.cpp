// SPDX-License-Identifier: GPL-3.0-or-later
//
// The clippers of spaces/ behind plain C functions.
#include "experiments/explorer/engine/engine.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "spaces/clippers.hpp"
#include "spaces/measured.hpp"

namespace clipscope::explorer {
namespace {

constexpr int kMostVertices = kMaxPolygonVertices;
constexpr int kNotApplicable = -1;

std::array<double, 3 * kVertexNumbers> g_numbers{};
std::array<double, (kMaxPlanes + 1) * (1 + kMostVertices * kVertexNumbers)> g_results{};
Frustum<double> g_frustum;
ClipVolume g_volume;

template <Scalar T>
Projection<T> projection() {
  Projection<T> r(frustum_cast<T>(g_frustum));
  r.volume = g_volume;
  return r;
}

template <Space S, Scalar T>
Simplex<S, T, kAttributes, 3> triangle() {
  Simplex<S, T, kAttributes, 3> r;
  for (int i = 0; i < 3; ++i) {
    const double* in = &g_numbers[static_cast<std::size_t>(i * kVertexNumbers)];
    for (int k = 0; k < (S == Space::view ? 3 : 4); ++k) r[i].position[k] = T(in[k]);
    for (int k = 0; k < kAttributes; ++k) r[i].attributes[k] = T(in[4 + k]);
  }
  return r;
}

// The triangle in clip space, whichever space its numbers are in.
template <Scalar T>
ClipTriangle<T, kAttributes> clip_triangle(bool from_clip_space) {
  if (from_clip_space) return triangle<Space::clip, T>();
  return to_clip(projection<T>(), triangle<Space::view, T>());
}

// Writes the vertices, with four numbers of position each, from `to` on; returns what follows.
template <class Vertices>
double* write(const Vertices& vertices, double* to) {
  for (const auto& v : vertices) {
    for (int k = 0; k < 4; ++k) *to++ = static_cast<double>(v.position[k]);
    for (int k = 0; k < kAttributes; ++k) *to++ = static_cast<double>(v.attributes[k]);
  }
  return to;
}

template <class C, Scalar T>
int clip(bool from_clip_space) {
  if (!is_applicable(C::promise, g_volume)) return kNotApplicable;
  NdcPolygon<T, kAttributes> polygon;
  if (from_clip_space) {
    if constexpr (ClipsClipSpace<C, T, kAttributes>) {
      C{}(g_volume, triangle<Space::clip, T>(), polygon);
    } else {
      return kNotApplicable;
    }
  } else if constexpr (ClipsViewSpace<C, T, kAttributes>) {
    if (!is_valid(frustum_cast<T>(g_frustum))) return kNotApplicable;
    C{}(projection<T>(), triangle<Space::view, T>(), polygon);
  } else {
    return kNotApplicable;
  }
  write(polygon, g_results.data());
  return static_cast<int>(polygon.size());
}

template <class C>
int clip_in(bool is_double, bool from_clip_space) {
  return is_double ? clip<C, double>(from_clip_space) : clip<C, float>(from_clip_space);
}

using ClipFunction = int (*)(bool, bool);

template <class... Cs>
constexpr std::array<ClipFunction, sizeof...(Cs)> functions_of(TypeList<Cs...>) {
  return {clip_in<Cs>...};
}
constexpr auto kFunctions = functions_of(AllClippers{});

// The name of the type, from the function's own as GCC and clang write it: "... [C = TYPE]" or
// "... [with C = TYPE; ...]".
template <class C>
std::string_view type_name() {
  const std::string_view text = __PRETTY_FUNCTION__;
  const std::string_view before = "C = ";
  const std::size_t from = text.find(before) + before.size();
  return text.substr(from, text.find_first_of(";]", from) - from);
}

template <class C>
std::string description() {
  const auto text = [](std::string_view s) { return '"' + std::string(s) + '"'; };
  const auto flag = [](bool b) { return std::string(b ? "true" : "false"); };
  return "{\"name\":" + text(C::name) + ",\"summary\":" + text(C::summary) +
         ",\"source\":" + text(C::source) + ",\"type\":" + text(type_name<C>()) +
         ",\"clipSpace\":" + flag(ClipsClipSpace<C, float, kAttributes>) +
         ",\"double\":" + flag(ClipsViewSpace<C, double, kAttributes>) + "}";
}

template <class... Cs>
std::string descriptions_of(TypeList<Cs...>) {
  std::string r;
  ((r += (r.empty() ? "[" : ",") + description<Cs>()), ...);
  return r + "]";
}

template <Scalar T>
void write_distances(bool from_clip_space) {
  double* to = g_results.data();
  for (const auto& v : clip_triangle<T>(from_clip_space)) {
    for (int p = 0; p < kMaxPlanes; ++p) {
      const bool is_there = p < kPlanes + g_volume.clip_distances;
      *to++ = is_there ? static_cast<double>(signed_distance(g_volume.depth, Plane(p), v)) : 0;
    }
    *to++ = static_cast<double>(clip_outcode(g_volume.depth, v.position) |
                                clip_distance_outcode(g_volume, v.attributes));
  }
}

template <Scalar T>
void write_steps(bool from_clip_space, const std::uint8_t* planes, int count) {
  using V = MeasuredVertex<Space::clip, T, kAttributes>;
  std::vector<V> polygon, rest;
  for (const auto& v : clip_triangle<T>(from_clip_space)) {
    polygon.push_back(measured(g_volume.depth, v));
  }
  double* to = g_results.data();
  const auto write_polygon = [&] {
    *to++ = static_cast<double>(polygon.size());
    to = write(polygon, to);
  };
  write_polygon();
  for (int i = 0; i < count; ++i) {
    const auto plane = static_cast<Plane>(planes[i]);
    cut(polygon, rest, [plane](const V& v) { return carried_distance(plane, v); });
    polygon.swap(rest);
    write_polygon();
  }
}

}  // namespace
}  // namespace clipscope::explorer

extern "C" {

double* clipscope_numbers() { return clipscope::explorer::g_numbers.data(); }
double* clipscope_results() { return clipscope::explorer::g_results.data(); }

const char* clipscope_clippers() {
  static const std::string text = clipscope::explorer::descriptions_of(clipscope::AllClippers{});
  return text.c_str();
}

int clipscope_clipper_count() { return static_cast<int>(clipscope::explorer::kFunctions.size()); }

void clipscope_set_frustum(int parallel, double left, double right, double bottom, double top,
                           double near, double far, int infinite_far, double shear_x,
                           double shear_y, int depth) {
  using namespace clipscope;
  explorer::g_frustum = {parallel ? ProjectionKind::parallel : ProjectionKind::perspective,
                         left,
                         right,
                         bottom,
                         top,
                         near,
                         far,
                         infinite_far != 0,
                         shear_x,
                         shear_y,
                         static_cast<DepthRange>(depth)};
  explorer::g_volume.depth = static_cast<DepthRange>(depth);
}

void clipscope_set_volume(int clamp_near, int clamp_far, int clip_distances, int open_sides) {
  using namespace clipscope;
  explorer::g_volume.depth_clamp = {clamp_near != 0, clamp_far != 0};
  explorer::g_volume.clip_distances = clip_distances;
  explorer::g_volume.open_sides = {(open_sides & 1) != 0, (open_sides & 2) != 0,
                                   (open_sides & 4) != 0, (open_sides & 8) != 0};
}

int clipscope_clip(int clipper, int is_double, int from_clip_space) {
  using namespace clipscope::explorer;
  return kFunctions[static_cast<std::size_t>(clipper)](is_double != 0, from_clip_space != 0);
}

void clipscope_project(int is_double) {
  using namespace clipscope::explorer;
  if (is_double) {
    write(clip_triangle<double>(false), g_results.data());
  } else {
    write(clip_triangle<float>(false), g_results.data());
  }
}

void clipscope_distances(int is_double, int from_clip_space) {
  using namespace clipscope::explorer;
  is_double ? write_distances<double>(from_clip_space != 0)
            : write_distances<float>(from_clip_space != 0);
}

void clipscope_steps(int is_double, int from_clip_space, const std::uint8_t* planes, int count) {
  using namespace clipscope::explorer;
  is_double ? write_steps<double>(from_clip_space != 0, planes, count)
            : write_steps<float>(from_clip_space != 0, planes, count);
}
}

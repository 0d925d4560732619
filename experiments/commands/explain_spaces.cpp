// SPDX-License-Identifier: GPL-3.0-or-later
//
// One primitive in each space.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "experiments/commands/explanation.hpp"
#include "experiments/report/outcode_text.hpp"
#include "spaces/cut.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments::commands {
namespace {

template <Space S, class T>
using Vertices = std::vector<Vertex<S, T, kRunTime>>;

// The value of a user plane at a point; the fourth coordinate is 1 in view space.
template <class T>
T plane_distance(const std::array<double, 4>& plane, const reference::InputVertex& vertex) {
  T sum(0);
  for (std::size_t i = 0; i < 4; ++i) {
    sum = sum + scalar_from<T>(plane[i]) * scalar_from<T>(vertex.position[i]);
  }
  return sum;
}

// The case in the scalar T, each number rounded once; user planes are clip distances in front of
// the attributes.
template <Space S, class T>
Vertices<S, T> vertices_in(const HardCase& hard_case) {
  Vertices<S, T> vertices;
  for (const reference::InputVertex& given : hard_case.vertices) {
    Vertex<S, T, kRunTime>& v = vertices.emplace_back();
    for (int i = 0; i < v.kDimension; ++i) {
      v.position[i] = scalar_from<T>(given.position[static_cast<std::size_t>(i)]);
    }
    const int planes = static_cast<int>(hard_case.planes.size());
    v.attributes.resize(planes + hard_case.attribute_count);
    for (int p = 0; p < planes; ++p) {
      v.attributes[p] = plane_distance<T>(hard_case.planes[static_cast<std::size_t>(p)], given);
    }
    for (int k = 0; k < hard_case.attribute_count; ++k) {
      v.attributes[planes + k] = scalar_from<T>(given.attributes[static_cast<std::size_t>(k)]);
    }
  }
  return vertices;
}

// The volume with the user planes as clip distances.
ClipVolume volume_of(const HardCase& hard_case) {
  ClipVolume volume = hard_case.volume;
  volume.clip_distances += static_cast<int>(hard_case.planes.size());
  return volume;
}

// x y z, and of clip space and NDC the fourth coordinate.
template <Space S, class T>
std::string position_text(const Vertex<S, T, kRunTime>& v) {
  std::string text;
  for (int i = 0; i < v.kDimension; ++i) {
    text += fmt::format(" {:>16.9g}", nearest_double(v.position[i]));
  }
  return text;
}

// Cuts by each plane of the volume that some vertex is outside of, and prints what is left; of what
// an open side does not own nothing is.
// where: the frustum in view space, else the depth range.
template <Space S, class T, class Where>
void print_cuts(Vertices<S, T> polygon, const ClipVolume& volume, const Where& where) {
  static constexpr std::array kOrder = {Plane::near,  Plane::far,    Plane::left,
                                        Plane::right, Plane::bottom, Plane::top};
  for_each_plane(planes_of(volume), kOrder, [&](Plane plane) {
    const auto distance = [&](const auto& v) { return signed_distance(where, plane, v); };
    std::string distances;
    bool crossed = false;
    for (const auto& v : polygon) {
      const T d = distance(v);
      distances += fmt::format(" {:.6g}", nearest_double(d));
      crossed = crossed || !(T(0) <= d);
    }
    if (!crossed) return;
    Vertices<S, T> left;
    cut(polygon, left, distance);
    fmt::print("    {}: distances{}; {} vertices become {}\n", plane_text(plane), distances,
               polygon.size(), left.size());
    polygon = std::move(left);
    for (std::size_t v = 0; v < polygon.size(); ++v) {
      fmt::print("      {}: {}\n", v, position_text(polygon[v]));
    }
  });
  for_each_plane(open_planes_of(volume), kOrder, [&](Plane side) {
    const auto is_inside = [&](const auto& v) { return T(0) < signed_distance(where, side, v); };
    if (polygon.empty() || std::ranges::any_of(polygon, is_inside)) return;
    fmt::print("    {}: open, and no vertex is strictly inside of it\n", plane_text(side));
    polygon.clear();
  });
  if (polygon.size() < 3) fmt::print("    nothing is left\n");
}

// Prints each vertex in view space or clip space, and what it is outside of; then the cuts.
template <Space S, class T, class Where>
void print_space(const Vertices<S, T>& vertices, const ClipVolume& volume, const Where& where,
                 bool with_cuts) {
  constexpr bool kView = S == Space::view;
  fmt::print("{}\n", kView ? "View space: x y z" : "\nClip space: x y z w");
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    Outcode code = clip_distance_outcode(volume, vertices[i].attributes);
    if constexpr (kView) code |= view_outcode(where, vertices[i].position);
    if constexpr (!kView) code |= clip_outcode(where, vertices[i].position);
    fmt::print("  v{}: {}  {}\n", i, position_text(vertices[i]),
               outcode_text(code & planes_of(volume)));
  }
  if (!with_cuts) return;
  fmt::print("  cuts in {} space\n", kView ? "view" : "clip");
  print_cuts(vertices, volume, where);
}

template <class T>
void print_ndc(const Vertices<Space::clip, T>& vertices, const ClipVolume& volume) {
  fmt::print("\nCanonical view volume, divided before any cut: x y z 1/w\n");
  Vertices<Space::ndc, T> divided;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const T& w = vertices[i].position[3];
    if (!can_divide_by(w)) {
      fmt::print("  v{} has w = 0: it can't be divided\n", i);
      return;
    }
    const auto& v = divided.emplace_back(to_ndc(vertices[i]));
    fmt::print("  v{}: {}  {}{}\n", i, position_text(v),
               outcode_text(ndc_outcode(volume.depth, v.position) & planes_of(volume)),
               T(0) < w ? "" : "; w <= 0: mirrored through the eye or at infinity");
  }
  fmt::print("  cuts in the volume\n");
  print_cuts(divided, volume, volume.depth);
}

// What clippers that start in clip space get.
template <class T>
Vertices<Space::clip, T> projected(const HardCase& hard_case) {
  if (hard_case.space == Space::clip) return vertices_in<Space::clip, T>(hard_case);
  Vertices<Space::clip, T> projected;
  for (const auto& v : vertices_in<Space::view, T>(hard_case)) {
    projected.push_back(hard_case.matrix ? to_clip(matrix_from<T>(*hard_case.matrix), v)
                                         : to_clip(projection_from<T>(hard_case.frustum), v));
  }
  return projected;
}

// The vertices in front of a matrix, which knows no planes there.
template <class T>
void print_given(const HardCase& hard_case) {
  fmt::print("Space of the input: x y z (a matrix as given leads to clip space)\n");
  const auto vertices = vertices_in<Space::view, T>(hard_case);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    fmt::print("  v{}: {}\n", i, position_text(vertices[i]));
  }
}

template <class T>
void print_spaces_in(const HardCase& hard_case) {
  const bool is_triangle = hard_case.primitive == Primitive::triangle;
  const ClipVolume volume = volume_of(hard_case);
  if (has_frustum(hard_case)) {
    print_space(vertices_in<Space::view, T>(hard_case), volume,
                projection_from<T>(hard_case.frustum).frustum, is_triangle);
  } else if (hard_case.matrix) {
    print_given<T>(hard_case);
  }
  const auto clip = projected<T>(hard_case);
  print_space(clip, volume, volume.depth, is_triangle);
  if (is_triangle) print_ndc(clip, volume);
}

template <class T>
nlohmann::json spaces_json_in(const HardCase& hard_case) {
  const ClipVolume volume = volume_of(hard_case);
  nlohmann::json json = nlohmann::json::array();
  const auto clip = projected<T>(hard_case);
  for (std::size_t i = 0; i < clip.size(); ++i) {
    const auto& [position, attributes] = clip[i];
    const Outcode code =
        (clip_outcode(volume.depth, position) | clip_distance_outcode(volume, attributes)) &
        planes_of(volume);
    nlohmann::json outside = nlohmann::json::array();
    for (int p = 0; p < kMaxPlanes; ++p) {
      if ((code >> p & 1) != 0) outside.push_back(plane_text(static_cast<Plane>(p)));
    }
    const reference::InputVertex& given = hard_case.vertices[i];
    const auto dimension = hard_case.space == Space::view ? 3 : 4;
    json.push_back(
        {{"position", std::vector(given.position.begin(), given.position.begin() + dimension)},
         {"attributes", std::vector(given.attributes.begin(),
                                    given.attributes.begin() + hard_case.attribute_count)},
         {"clip",
          {nearest_double(position[0]), nearest_double(position[1]), nearest_double(position[2]),
           nearest_double(position[3])}},
         {"outside", outside}});
  }
  return json;
}

}  // namespace

void print_spaces(const HardCase& hard_case, const Format& format) {
  with_scalar(format, [&]<class T>() { print_spaces_in<T>(hard_case); });
}

nlohmann::json spaces_json(const HardCase& hard_case, const Format& format) {
  return with_scalar(format, [&]<class T>() { return spaces_json_in<T>(hard_case); });
}

}  // namespace clipscope::experiments::commands

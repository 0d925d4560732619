// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/plane_order/triangle_sets.hpp"

#include <functional>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/measure/batches.hpp"
#include "experiments/scenes/random.hpp"

namespace clipscope::experiments {
namespace {

using Triangle4 = ClipTriangle<float, kSceneAttributes>;

// Adds the triangle if some plane cuts it and none rejects it. Of such a triangle with all vertices inside
// nothing would depend on an order.
void add_if_cut(const Triangle4& triangle, TriangleSet& set) {
  const OutcodeSummary code = summarize_outcodes(
      ClipVolume{.depth = set.depth}, triangle,
      [&](std::size_t i) { return clip_outcode(set.depth, triangle[i].position); });
  if (code.all == 0 && code.any != 0) set.triangles.push_back({triangle, code.any});
}

// Computed in double, each coordinate rounded to float once.
Triangle4 clip_triangle(const Projection<double>& projection, const SceneTriangle& triangle) {
  const auto clip = to_clip(projection, simplex_cast<double>(triangle));
  Triangle4 result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (int c = 0; c < 4; ++c) {
      result[i].position[c] = static_cast<float>(clip[i].position[c]);
    }
    result[i].attributes = triangle[i].attributes;
  }
  return result;
}

void add_scene(const Scene& scene, TriangleSet& set) {
  set.depth = scene.views.front().frustum.depth;
  std::vector<SceneTriangle> triangles(scene.mesh.triangles.size());
  for (const View& view : scene.views) {
    view_triangles(scene, view, 0, triangles);
    const auto projection = projection_of<double>(view);
    for (const SceneTriangle& t : triangles) add_if_cut(clip_triangle(projection, t), set);
  }
}

// Barycentric coordinates and 1.
Attributes<float, kSceneAttributes> corner_attributes(std::size_t corner) {
  Attributes<float, kSceneAttributes> a = {{0, 0, 0, 1}};
  a[static_cast<int>(corner)] = 1;
  return a;
}

void add_random(const std::function<double()>& coordinate, std::size_t limit, TriangleSet& set) {
  while (set.triangles.size() < limit) {
    Triangle4 triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      for (int c = 0; c < 4; ++c) triangle[i].position[c] = static_cast<float>(coordinate());
      triangle[i].attributes = corner_attributes(i);
    }
    add_if_cut(triangle, set);
  }
}

void add_hard_cases(TriangleSet& set) {
  for (const HardCase& c : builtin_catalogue()) {
    const bool plain = c.volume == ClipVolume{.depth = set.depth};
    if (c.primitive != Primitive::triangle || c.space != Space::clip || !plain) continue;
    Triangle4 triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      for (int k = 0; k < 4; ++k) {
        triangle[i].position[k] =
            static_cast<float>(c.vertices[i].position[static_cast<std::size_t>(k)]);
      }
      triangle[i].attributes = corner_attributes(i);
    }
    add_if_cut(triangle, set);
  }
}

void thin(std::size_t limit, std::vector<CutTriangle>& triangles) {
  if (triangles.size() <= limit) return;
  const std::size_t stride = (triangles.size() + limit - 1) / limit;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < triangles.size(); i += stride) triangles[kept++] = triangles[i];
  triangles.resize(kept);
}

}  // namespace

std::vector<std::string> set_names(const Selection& selection) {
  std::vector<std::string> names = selection.scenes;
  if (names.empty()) names = {"soup_straddling", "soup_behind", "slivers", "floor", "corridor"};
  names.insert(names.end(), {"mixed_w", "lattice", "hard_cases"});
  return names;
}

TriangleSet make_set(const Selection& selection, const std::string& name, std::size_t limit) {
  TriangleSet set{name, DepthRange::minus_one_to_one, {}};
  Random random(selection.seed);
  if (name == "mixed_w") {
    add_random([&] { return random.uniform(-2, 2); }, limit, set);
  } else if (name == "lattice") {
    add_random([&] { return static_cast<double>(random.below(5)) - 2; }, limit, set);
  } else if (name == "hard_cases") {
    add_hard_cases(set);
  } else {
    add_scene(load_selected_scene(selection, name), set);
  }
  thin(limit, set.triangles);
  return set;
}

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/survey/draw_scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "experiments/judge/compare.hpp"
#include "experiments/machine/errors.hpp"

namespace clipscope::experiments {
namespace {

using ScreenPolygon = std::vector<ScreenVertex>;

// Calls polygons_of(triangles) for chunks of the mesh and draws the polygons it returns, one for
// each triangle.
template <class F>
FrameBuffer draw(const Scene& scene, const View& view, const PictureSize& size, F&& polygons_of) {
  FrameBuffer buffer(size.width, size.height, view.frustum.depth);
  const auto draw_chunk = [&](std::span<const SceneTriangle> triangles, std::size_t first) {
    const std::vector<ScreenPolygon> polygons = polygons_of(triangles);
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      draw_polygon(buffer, polygons[i], static_cast<std::uint32_t>(first + i));
    }
  };
  for_each_chunk(scene, view, spacing_of(scene, 0), draw_chunk);
  return buffer;
}

ScreenVertex screen_vertex(const VertexView& v) {
  ScreenVertex s{v[0].value, v[1].value, v[2].value, v[3].value, {}};
  const std::size_t count = std::min(s.attributes.size(), v.size() - 4);  // guests may take fewer
  for (std::size_t k = 0; k < count; ++k) s.attributes[k] = v[4 + k].value;
  return s;
}

ScreenVertex screen_vertex(const std::vector<double>& v) {
  return {v[0], v[1], v[2], v[3], {v[4], v[5], v[6], v[7]}};
}

}  // namespace

FrameBuffer draw_with(const Contestant& contestant, const Scene& scene, const View& view,
                      const PictureSize& size) {
  return draw(scene, view, size, [&](std::span<const SceneTriangle> triangles) {
    const Answers answers = clip(contestant, batch_of(view, triangles));
    std::vector<ScreenPolygon> polygons(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      for (const VertexView& v : answers[i]) polygons[i].push_back(screen_vertex(v));
    }
    return polygons;
  });
}

FrameBuffer draw_exact(const Scene& scene, const View& view, const PictureSize& size) {
  const reference::Truth truth = truth_of(view);
  return draw(scene, view, size, [&](std::span<const SceneTriangle> triangles) {
    std::vector<ScreenPolygon> polygons;
    for (const TruthPolygon& exact : truth_polygons(truth, batch_of(view, triangles))) {
      ScreenPolygon& polygon = polygons.emplace_back();
      for (const std::vector<double>& v : exact.approximation) polygon.push_back(screen_vertex(v));
    }
    return polygons;
  });
}

const View& find_view(const Scene& scene, std::string_view label) {
  if (label.empty()) return scene.views.front();
  std::vector<std::string> labels;
  for (const View& view : scene.views) {
    if (view.label == label) return view;
    labels.push_back(view.label);
  }
  throw UsageError(fmt::format("--view: scene {} has no view '{}'; it has: {}", scene.name, label,
                               fmt::join(labels, ", ")));
}

}  // namespace clipscope::experiments

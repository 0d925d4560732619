// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/pictures/draw_scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "experiments/errors.hpp"
#include "experiments/measure/batches.hpp"
#include "experiments/measure/compare.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kChunk = 4096;  // triangles

using ScreenPolygon = std::vector<ScreenVertex>;

// Calls polygons_of(triangles) for chunks of the mesh and draws the polygons it returns, one for each
// triangle.
template <class F>
FrameBuffer draw(const Scene& scene, const View& view, const PictureSize& size, F&& polygons_of) {
  FrameBuffer buffer(size.width, size.height, view.frustum.depth);
  const Sample all = sample_of(scene, 0);
  for (std::size_t first = 0; first < all.count; first += kChunk) {
    const std::size_t count = std::min(kChunk, all.count - first);
    const std::vector<ScreenPolygon> polygons =
        polygons_of(sampled_view_triangles(scene, view, all, first, count));
    for (std::size_t i = 0; i < count; ++i) {
      draw_polygon(buffer, polygons[i], static_cast<std::uint32_t>(first + i));
    }
  }
  return buffer;
}

template <class T, int K>
ScreenVertex screen_vertex(const NdcVertex<T, K>& v) {
  ScreenVertex s{nearest_double(v.position[0]),
                 nearest_double(v.position[1]),
                 nearest_double(v.position[2]),
                 nearest_double(v.position[3]),
                 {}};
  for (int k = 0; k < kScreenAttributes; ++k) {
    s.attributes[static_cast<std::size_t>(k)] = nearest_double(v.attributes[k]);
  }
  return s;
}

ScreenVertex screen_vertex(const std::vector<double>& v) {
  return {v[0], v[1], v[2], v[3], {v[4], v[5], v[6], v[7]}};
}

template <class T>
std::vector<ScreenPolygon> clipped_by(const Contestant<T>& contestant,
                                      const Projection<T>& projection,
                                      std::span<const SceneTriangle> triangles) {
  PolygonStream<T, kSceneAttributes> stream;
  contestant.view(projection, simplices_cast<T>(triangles), stream);
  std::vector<ScreenPolygon> polygons(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (const auto& v : stream[i]) polygons[i].push_back(screen_vertex(v));
  }
  return polygons;
}

}  // namespace

FrameBuffer draw_with(const AnyContestant& any, const Scene& scene, const View& view,
                      const PictureSize& size) {
  return std::visit(
      [&]<class T>(const Contestant<T>* contestant) {
        const auto projection = projection_of<T>(view);
        return draw(scene, view, size, [&](std::span<const SceneTriangle> triangles) {
          return clipped_by(*contestant, projection, triangles);
        });
      },
      any);
}

FrameBuffer draw_exact(const Scene& scene, const View& view, const PictureSize& size) {
  const auto truth = reference::Truth::of_frustum(frustum_cast<double>(view.frustum));
  return draw(scene, view, size, [&](std::span<const SceneTriangle> triangles) {
    std::vector<ScreenPolygon> polygons(triangles.size());
    tbb::parallel_for(std::size_t{0}, triangles.size(), [&](std::size_t i) {
      for (const auto& v :
           truth_polygon(truth, reference::input_triangle(triangles[i])).approximation) {
        polygons[i].push_back(screen_vertex(v));
      }
    });
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

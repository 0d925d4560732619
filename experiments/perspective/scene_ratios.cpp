// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/perspective/scene_ratios.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "experiments/measure/batches.hpp"
#include "experiments/measure/compare.hpp"
#include "experiments/perspective/affine_error.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kChunk = 4096;  // triangles
constexpr int kSplits = 2;            // each makes four triangles of one

using TextureTriangle = std::array<TextureCorner, 3>;

TextureCorner middle(const TextureCorner& a, const TextureCorner& b) {
  return {(a.w + b.w) / 2, (a.u + b.u) / 2, (a.v + b.v) / 2};
}

double edge_error(const TextureCorner& a, const TextureCorner& b) {
  return std::max(std::abs(b.u - a.u), std::abs(b.v - a.v)) * affine_bound(a.w, b.w);
}

double largest_error(const TextureTriangle& t, int splits) {
  if (splits == 0) {
    return std::max({edge_error(t[0], t[1]), edge_error(t[1], t[2]), edge_error(t[2], t[0])});
  }
  const TextureCorner a = middle(t[1], t[2]), b = middle(t[2], t[0]), c = middle(t[0], t[1]);
  return std::max({largest_error({t[0], c, b}, splits - 1), largest_error({c, t[1], a}, splits - 1),
                   largest_error({b, a, t[2]}, splits - 1), largest_error({a, b, c}, splits - 1)});
}

// Of a triangle of the scene: nothing if it isn't visible.
std::vector<TextureCorner> visible_corners(const reference::Truth& truth,
                                           const SceneTriangle& triangle) {
  const TruthPolygon polygon = truth_polygon(truth, reference::input_triangle(triangle));
  std::vector<TextureCorner> corners;
  if (!polygon.is_visible()) return corners;
  for (const std::vector<double>& v : polygon.approximation) {
    corners.push_back({1 / v[3], v[4], v[5]});
  }
  return corners;
}

}  // namespace

PolygonNeed need_of(std::span<const TextureCorner> polygon) {
  const auto [low, high] = std::ranges::minmax_element(polygon, {}, &TextureCorner::w);
  PolygonNeed need{.ratio = high->w / low->w};
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const TextureTriangle fan = {polygon[0], polygon[i - 1], polygon[i]};
    need.error = std::max(need.error, largest_error(fan, 0));
    need.error_split = std::max(need.error_split, largest_error(fan, kSplits));
  }
  return need;
}

std::vector<PolygonNeed> scene_needs(const Scene& scene, std::size_t triangles_per_view,
                                     Progress& progress) {
  const Sample sample = sample_of(scene, triangles_per_view);
  std::vector<PolygonNeed> needs;
  for (const View& view : scene.views) {
    const auto truth = reference::Truth::of_frustum(frustum_cast<double>(view.frustum));
    for (std::size_t first = 0; first < sample.count; first += kChunk) {
      const std::size_t count = std::min(kChunk, sample.count - first);
      const auto triangles = sampled_view_triangles(scene, view, sample, first, count);
      std::vector<std::vector<TextureCorner>> polygons(count);
      tbb::parallel_for(std::size_t{0}, count,
                        [&](std::size_t i) { polygons[i] = visible_corners(truth, triangles[i]); });
      for (const auto& polygon : polygons) {
        if (!polygon.empty()) needs.push_back(need_of(polygon));
      }
      progress.advance(count);
    }
  }
  return needs;
}

}  // namespace clipscope::experiments

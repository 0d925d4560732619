// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/perspective/cvv_vertices.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "experiments/measure/batches.hpp"
#include "experiments/measure/compare.hpp"
#include "experiments/measure/sweep.hpp"
#include "experiments/scenes/random.hpp"

namespace clipscope::experiments {
namespace {

constexpr float kNearest = 2;  // w of the nearest vertex, twice that of the near plane

// A vertex at this w, up to twice the half width of the volume off its axis.
ViewVertex<float, kSceneAttributes> vertex_at(float w, Random& random) {
  ViewVertex<float, kSceneAttributes> v;
  v.position[0] = static_cast<float>(random.uniform(-2, 2) * w);
  v.position[1] = static_cast<float>(random.uniform(-2, 2) * w);
  v.position[2] = -w;
  for (int k = 0; k < kSceneAttributes; ++k) {
    v.attributes[k] = static_cast<float>(random.uniform());
  }
  return v;
}

SceneTriangle random_triangle(float ratio, Random& random) {
  const float farthest = kNearest * ratio;
  const auto between = static_cast<float>(random.across_magnitudes(kNearest, farthest));
  std::array<float, 3> w = {kNearest, farthest, between};
  random.shuffle(std::span<float>(w));
  SceneTriangle triangle;
  for (std::size_t i = 0; i < 3; ++i) triangle[i] = vertex_at(w[i], random);
  return triangle;
}

}  // namespace

Frustum<float> cut_frustum() {
  return {.left = -1, .right = 1, .bottom = -1, .top = 1, .near = 1, .far = 131072};
}

std::vector<SceneTriangle> cut_triangles(float ratio, std::size_t count, std::uint64_t seed) {
  const auto truth = reference::Truth::of_frustum(frustum_cast<double>(cut_frustum()));
  Random random(seed);
  std::vector<SceneTriangle> triangles;
  while (triangles.size() < count) {
    const SceneTriangle triangle = random_triangle(ratio, random);
    const auto exact = reference::clip(truth, reference::input_triangle(triangle));
    if (exact.verdict == reference::Verdict::clipped && exact.vertices.size() >= 3) {
      triangles.push_back(triangle);
    }
  }
  return triangles;
}

CutError attribute_error_of_cut(const AnyContestant& any,
                                const std::vector<SceneTriangle>& triangles) {
  const auto truth = reference::Truth::of_frustum(frustum_cast<double>(cut_frustum()));
  std::vector<Comparison> comparisons(triangles.size());
  std::visit(
      [&]<class T>(const Contestant<T>* contestant) {
        PolygonStream<T, kSceneAttributes> polygons;
        contestant->view(projection_from<T>(frustum_cast<double>(cut_frustum())),
                         simplices_cast<T>(triangles), polygons);
        tbb::parallel_for(std::size_t{0}, triangles.size(), [&](std::size_t i) {
          comparisons[i] = compare<T, kSceneAttributes>(
              polygons[i], truth_polygon(truth, reference::input_triangle(triangles[i])));
        });
      },
      any);
  CutError result;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    if (comparisons[i].outcome > Outcome::visible) continue;
    ++result.triangles;
    if (comparisons[i].attribute > result.max) {
      result.max = comparisons[i].attribute;
      worst = i;
    }
  }
  if (result.max > 0) {
    SweepChunk chunk;
    chunk.frustum = cut_frustum();
    chunk.view = {triangles[worst]};
    result.worst = replay_text(chunk, 0);
  }
  return result;
}

WorstInput worst_input(const AnyContestant& contestant, const CutError& error) {
  const std::size_t colon = error.worst.find(" :");
  const std::string options = error.worst.substr(0, colon);
  const std::string numbers = colon == std::string::npos ? "" : error.worst.substr(colon + 3);
  return {std::string(clipper_name(contestant)),
          std::string(scalar_name(contestant)),
          "attribute",
          error.max,
          numbers,
          fmt::format("echo '{}' | clipscope explain {} --clipper {} --scalar {}", numbers, options,
                      clipper_name(contestant), scalar_name(contestant))};
}

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles of a scene's views as clippers take them: sampled, cut into chunks, in any scalar.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "experiments/contestants/scalars.hpp"
#include "experiments/scenes/scene.hpp"
#include "reference/exact_clip.hpp"

namespace clipscope::experiments {

// Some triangles of a mesh, evenly spaced: number i is triangle i * stride.
struct Sample {
  std::size_t count = 0;
  std::size_t stride = 1;
};

// At most `limit` triangles of the scene; 0: all.
inline Sample sample_of(const Scene& scene, std::size_t limit) {
  const std::size_t triangles = scene.mesh.triangles.size();
  if (limit == 0 || triangles <= limit) return {triangles, 1};
  const std::size_t stride = (triangles + limit - 1) / limit;
  return {(triangles + stride - 1) / stride, stride};
}

// The sampled triangles [first, first + count) of a view.
inline std::vector<SceneTriangle> sampled_view_triangles(const Scene& scene, const View& view,
                                                         const Sample& sample, std::size_t first,
                                                         std::size_t count) {
  std::vector<SceneTriangle> triangles(count);
  if (sample.stride == 1) {
    view_triangles(scene, view, first, triangles);
    return triangles;
  }
  for (std::size_t i = 0; i < count; ++i) {
    view_triangles(scene, view, (first + i) * sample.stride, std::span(triangles).subspan(i, 1));
  }
  return triangles;
}

// The same bits in another scalar: a point, a segment or a triangle.
template <class T, Space S, int K, std::size_t N>
Simplex<S, T, K, N> simplex_cast(const Simplex<S, float, K, N>& simplex) {
  Simplex<S, T, K, N> result;
  for (std::size_t i = 0; i < N; ++i) {
    for (int c = 0; c < Vertex<S, T, K>::kDimension; ++c) {
      result[i].position[c] = scalar_from<T>(simplex[i].position[c]);
    }
    for (int k = 0; k < K; ++k) {
      result[i].attributes[k] = scalar_from<T>(simplex[i].attributes[k]);
    }
  }
  return result;
}

// The same triangle with the number of its attributes known at run time only.
template <Space S, class T, int K>
Triangle<S, T, kRunTime> with_run_time_attributes(const Triangle<S, T, K>& triangle) {
  Triangle<S, T, kRunTime> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i].position = triangle[i].position;
    result[i].attributes.resize(K);
    for (int k = 0; k < K; ++k) result[i].attributes[k] = triangle[i].attributes[k];
  }
  return result;
}

// Simplices: a vector or a span of them in float.
template <class T, class Simplices>
auto simplices_cast(const Simplices& simplices) {
  std::vector<decltype(simplex_cast<T>(*simplices.begin()))> result;
  result.reserve(simplices.size());
  for (const auto& simplex : simplices) result.push_back(simplex_cast<T>(simplex));
  return result;
}

// The projection of a view in scalar T: the frustum's floats are exact in every scalar, the matrix is
// rounded to T.
template <class T>
Projection<T> projection_of(const View& view) {
  return projection_from<T>(frustum_cast<double>(view.frustum));
}

}  // namespace clipscope::experiments

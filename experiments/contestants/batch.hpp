// SPDX-License-Identifier: GPL-3.0-or-later
//
// A batch: the primitives that contestants are given, and what they are clipped against.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "experiments/contestants/scalars.hpp"
#include "experiments/scenes/scene.hpp"
#include "spaces/projection.hpp"
#include "spaces/vertex.hpp"
#include "spaces/volume.hpp"

namespace clipscope::reference {
class Truth;
struct InputVertex;
}  // namespace clipscope::reference

namespace clipscope::experiments {

// What points have beside their vertex: the side of the square and the size of the viewport, both
// px.
struct PointOptions {
  double size = 0;
  std::array<double, 2> viewport = {1, 1};
};

// Numbers are floats or doubles; a contestant rounds each to its scalar once. They stay the
// owner's.
struct Batch {
  Space space = Space::view;     // view or clip
  Frustum<double> frustum = {};  // of view space
  // From view space to clip space, instead of the frustum: each contestant rounds it to its scalar
  // and starts with clip coordinates.
  std::optional<MatrixRows<double>> matrix = {};
  ClipVolume volume = {};
  int vertices = 3;    // of a primitive: 1, 2 or 3; 0: polygons, see `ends`
  int attributes = 0;  // per vertex
  // Vertex after vertex: position (3 numbers in view space, 4 in clip space), then attributes.
  std::variant<std::span<const float>, std::span<const double>> numbers = {};
  // Polygon i has the vertices [ends[i - 1], ends[i]).
  std::span<const std::size_t> ends = {};
  // Inside is a x + b y + c z + d (w) >= 0. They become clip distances in front of the attributes.
  std::vector<std::array<double, 4>> planes = {};
  std::optional<PointOptions> point = {};

  int dimension() const { return space == Space::view ? 3 : 4; }
  std::size_t stride() const { return static_cast<std::size_t>(dimension() + attributes); }
  std::size_t size() const;  // primitives
  double number(std::size_t i) const;
};

// The numbers of simplices, one after the other.
template <Space S, class T, int K, std::size_t N>
std::span<const T> numbers_of(std::span<const Simplex<S, T, K, N>> simplices) {
  constexpr std::size_t kNumbers = N * (Vertex<S, T, K>::kDimension + K);
  static_assert(K > 0 && sizeof(Simplex<S, T, K, N>) == kNumbers * sizeof(T), "no padding");
  if (simplices.empty()) return {};
  return {&simplices.front()[0].position[0], simplices.size() * kNumbers};
}

template <class T, int K, std::size_t N>
Batch batch_of(const Frustum<float>& frustum,
               std::span<const Simplex<Space::view, T, K, N>> simplices) {
  return {.space = Space::view,
          .frustum = frustum_cast<double>(frustum),
          .volume = {.depth = frustum.depth},
          .vertices = static_cast<int>(N),
          .attributes = K,
          .numbers = numbers_of(simplices)};
}

template <class T, int K, std::size_t N>
Batch batch_of(const ClipVolume& volume, std::span<const Simplex<Space::clip, T, K, N>> simplices) {
  return {.space = Space::clip,
          .volume = volume,
          .vertices = static_cast<int>(N),
          .attributes = K,
          .numbers = numbers_of(simplices)};
}

// The triangles of a view; of several views a batch each.
Batch batch_of(const View& view, std::span<const SceneTriangle> triangles);
Batch batch_of(const View& view, std::span<const DoubleSceneTriangle> triangles);
std::vector<Batch> batches_of(std::span<const SampledView> views);

// Whether a scalar of the format gets a scene's triangles in double: where it holds more than a
// float does, and so does the mesh.
bool takes_doubles(const Format& format, const Scene& scene);

// What the triangles of a view are clipped against: its exact frustum, or its matrix as given.
reference::Truth truth_of(const View& view);

// The vertices of a primitive as the exact reference takes them.
std::vector<reference::InputVertex> input_vertices(const Batch& batch, std::size_t primitive);

}  // namespace clipscope::experiments

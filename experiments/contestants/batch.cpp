// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/contestants/batch.hpp"

#include "reference/truth.hpp"

namespace clipscope::experiments {

std::size_t Batch::size() const {
  if (vertices == 0) return ends.size();
  const std::size_t count = std::visit([](const auto& n) { return n.size(); }, numbers);
  return count / (stride() * static_cast<std::size_t>(vertices));
}

double Batch::number(std::size_t i) const {
  return std::visit([i](const auto& n) { return double{n[i]}; }, numbers);
}

namespace {

template <class Triangle>
Batch any_batch_of(const View& view, std::span<const Triangle> triangles) {
  Batch batch = batch_of(view.frustum, triangles);
  if (view.matrix) batch.matrix = matrix_cast<double>(*view.matrix);
  return batch;
}

}  // namespace

Batch batch_of(const View& view, std::span<const SceneTriangle> triangles) {
  return any_batch_of(view, triangles);
}
Batch batch_of(const View& view, std::span<const DoubleSceneTriangle> triangles) {
  return any_batch_of(view, triangles);
}

bool takes_doubles(const Format& format, const Scene& scene) {
  return !format.is_float() && !scene.mesh.double_positions.empty();
}

reference::Truth truth_of(const View& view) {
  return reference::truth_of(batch_of(view, std::span<const SceneTriangle>()));
}

std::vector<Batch> batches_of(std::span<const SampledView> views) {
  std::vector<Batch> batches;
  for (const SampledView& v : views) batches.push_back(batch_of(v.view, v.triangles));
  return batches;
}

std::vector<reference::InputVertex> input_vertices(const Batch& batch, std::size_t primitive) {
  const std::size_t n = static_cast<std::size_t>(batch.vertices);
  const std::size_t first = n > 0 ? primitive * n : primitive > 0 ? batch.ends[primitive - 1] : 0;
  const std::size_t end = n > 0 ? first + n : batch.ends[primitive];
  std::vector<reference::InputVertex> vertices;
  for (std::size_t v = first; v < end; ++v) {
    reference::InputVertex& vertex = vertices.emplace_back();
    std::size_t next = v * batch.stride();
    for (int i = 0; i < batch.dimension(); ++i) {
      vertex.position[static_cast<std::size_t>(i)] = batch.number(next++);
    }
    for (int k = 0; k < batch.attributes; ++k) {
      vertex.attributes[static_cast<std::size_t>(k)] = batch.number(next++);
    }
  }
  return vertices;
}

}  // namespace clipscope::experiments

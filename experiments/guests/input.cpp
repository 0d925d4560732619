// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guests/input.hpp"

#include "experiments/contestants/typed_input.hpp"

namespace clipscope::experiments {
namespace {

template <Space S, Scalar T>
void add_vertex(const Vertex<S, T, kRunTime>& vertex, GuestInput& input) {
  for (int i = 0; i < vertex.kDimension; ++i) input.numbers.push_back(vertex.position[i]);
  for (int k = 0; k < input.attributes; ++k) input.numbers.push_back(vertex.attributes[k]);
}

template <Scalar T>
void add_vertices(const Batch& batch, std::size_t count, GuestInput& input) {
  if (batch.space == Space::clip) {
    const VertexReader<Space::clip, T, kRunTime> read(batch);
    for (std::size_t v = 0; v < count; ++v) add_vertex(read(v), input);
    return;
  }
  const VertexReader<Space::view, T, kRunTime> read(batch);
  const Projection<T> projection = projection_in<T>(batch);
  const MatrixRows<T> rows = batch.matrix ? matrix_from<T>(*batch.matrix) : MatrixRows<T>{};
  for (std::size_t v = 0; v < count; ++v) {
    if (input.space == Space::view) {
      add_vertex(read(v), input);
    } else if (batch.matrix) {
      add_vertex(to_clip(rows, read(v)), input);
    } else {
      add_vertex(to_clip(projection, read(v)), input);
    }
  }
}

}  // namespace

GuestInput guest_input(const Batch& batch, const Format& format, Space space) {
  const int planes = static_cast<int>(batch.planes.size());
  GuestInput input{.space = space, .volume = batch.volume, .attributes = batch.attributes + planes};
  input.volume.clip_distances += planes;
  const std::size_t primitives = batch.size();
  for (std::size_t i = 0; i < primitives; ++i) {
    input.ends.push_back(batch.vertices == 0 ? batch.ends[i]
                                             : (i + 1) * static_cast<std::size_t>(batch.vertices));
  }
  const std::size_t vertices = input.ends.empty() ? 0 : input.ends.back();
  input.numbers.reserve(vertices * input.stride());
  if (format.is_float()) {
    add_vertices<float>(batch, vertices, input);
  } else {
    add_vertices<double>(batch, vertices, input);
  }
  return input;
}

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guests/plugin_task.hpp"

#include <algorithm>
#include <type_traits>

#include "experiments/contestants/typed_input.hpp"

namespace clipscope::experiments {
namespace {

template <class T>
clipscope_frustum frustum_of(const Frustum<T>& f) {
  clipscope_frustum to{};
  to.left = f.left;
  to.right = f.right;
  to.bottom = f.bottom;
  to.top = f.top;
  to.z_near = f.near;
  to.z_far = f.infinite_far ? T(0) : f.far;
  to.shear_x = f.shear_x;
  to.shear_y = f.shear_y;
  to.is_orthographic = f.kind == ProjectionKind::parallel;
  to.is_infinite = f.infinite_far;
  return to;
}

void set_volume_of(const ClipVolume& volume, clipscope_task& task) {
  const DepthClamp& clamp = volume.depth_clamp;
  const OpenSides& open = volume.open_sides;
  task.depth = depth_bit(volume.depth);
  task.depth_clamp =
      (clamp.near ? CLIPSCOPE_CLAMP_NEAR : 0) | (clamp.far ? CLIPSCOPE_CLAMP_FAR : 0);
  task.open_sides = (open.left ? CLIPSCOPE_OPEN_LEFT : 0) |
                    (open.right ? CLIPSCOPE_OPEN_RIGHT : 0) |
                    (open.bottom ? CLIPSCOPE_OPEN_BOTTOM : 0) | (open.top ? CLIPSCOPE_OPEN_TOP : 0);
  task.clip_distances = static_cast<std::uint32_t>(volume.clip_distances);
}

template <Space S, class T>
void write_vertices_of(const Batch& batch, T* to) {
  const std::size_t vertices = first_vertex(batch, batch.size());
  const VertexReader<S, T, kRunTime> read(batch);
  for (std::size_t v = 0; v < vertices; ++v) {
    const Vertex<S, T, kRunTime> vertex = read(v);
    for (int i = 0; i < vertex.kDimension; ++i) *to++ = vertex.position[i];
    for (int k = 0; k < vertex.attributes.size(); ++k) *to++ = vertex.attributes[k];
  }
}

}  // namespace

std::uint32_t primitive_bit(int vertices) {
  if (vertices == 0) return CLIPSCOPE_POLYGONS;
  return static_cast<std::uint32_t>(CLIPSCOPE_POINTS) << (vertices - 1);
}
std::uint32_t depth_bit(DepthRange depth) {
  return static_cast<std::uint32_t>(CLIPSCOPE_DEPTH_MINUS_ONE_TO_ONE) << static_cast<int>(depth);
}

bool takes_in_view_space(const Plugin& plugin, const Frustum<double>& f) {
  const bool is_parallel = f.kind == ProjectionKind::parallel;
  const bool is_centred = f.left == -f.right && f.bottom == -f.top;
  const bool is_oblique = f.shear_x != 0 || f.shear_y != 0;
  return plugin.can(CLIPSCOPE_VIEW_SPACE) && (is_centred || plugin.can(CLIPSCOPE_OFF_CENTRE)) &&
         (!is_parallel || plugin.can(CLIPSCOPE_ORTHOGRAPHIC)) &&
         (!is_oblique || plugin.can(CLIPSCOPE_OBLIQUE)) &&
         (!f.infinite_far || plugin.can(CLIPSCOPE_INFINITE_FAR));
}

template <class T>
clipscope_task task_of(const Batch& batch) {
  const Projection<T> projection = projection_in<T>(batch);
  clipscope_task task{};
  task.struct_size = sizeof task;
  task.scalar = std::is_same_v<T, float> ? CLIPSCOPE_FLOAT : CLIPSCOPE_DOUBLE;
  task.space = batch.space == Space::view ? CLIPSCOPE_VIEW_SPACE : CLIPSCOPE_CLIP_SPACE;
  task.primitive = primitive_bit(batch.vertices);
  task.attributes = static_cast<std::uint32_t>(batch.attributes) +
                    static_cast<std::uint32_t>(batch.planes.size());
  task.stride = static_cast<std::uint32_t>(batch.dimension()) + task.attributes;
  set_volume_of(projection.volume, task);
  if (batch.space == Space::view) {
    if (!batch.matrix) task.frustum = frustum_of(projection.frustum);
    const MatrixRows<T> rows = batch.matrix ? matrix_from<T>(*batch.matrix) : rows_of(projection);
    for (std::size_t i = 0; i < 16; ++i) task.matrix[i] = rows[i / 4][static_cast<int>(i % 4)];
  }
  const PointSize<T> size = point_size_in<T>(batch);
  task.point_half_size[0] = size.half_width;
  task.point_half_size[1] = size.half_height;
  return task;
}

std::size_t first_vertex(const Batch& batch, std::size_t primitive) {
  if (batch.vertices > 0) return primitive * static_cast<std::size_t>(batch.vertices);
  return primitive == 0 ? 0 : batch.ends[primitive - 1];
}

std::size_t most_vertices(const Batch& batch, const clipscope_task& task) {
  if (batch.vertices == 1 || batch.vertices == 2) return static_cast<std::size_t>(batch.vertices);
  std::size_t largest = 3;
  for (std::size_t i = 0; i < batch.ends.size(); ++i) {
    largest = std::max(largest, first_vertex(batch, i + 1) - first_vertex(batch, i));
  }
  return largest + 7 + task.clip_distances;
}

template <class T>
void write_vertices(const Batch& batch, T* to) {
  if (batch.space == Space::view) return write_vertices_of<Space::view>(batch, to);
  write_vertices_of<Space::clip>(batch, to);
}

template clipscope_task task_of<float>(const Batch&);
template clipscope_task task_of<double>(const Batch&);
template void write_vertices(const Batch&, float*);
template void write_vertices(const Batch&, double*);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// A batch's input in one scalar: its vertices and what they are clipped against.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "experiments/contestants/batch.hpp"
#include "experiments/contestants/scalars.hpp"
#include "spaces/planes.hpp"
#include "spaces/point/points.hpp"

namespace clipscope::experiments {

// Reads a batch into a scalar, each number rounded once, the distances to the user's planes in
// front of the attributes.
template <Space S, Scalar T, int K>
class VertexReader {
 public:
  explicit VertexReader(const Batch& batch) : batch_(batch) {
    for (const std::array<double, 4>& plane : batch.planes) {
      for (const double x : plane) planes_.push_back(scalar_from<T>(x));
    }
  }
  Vertex<S, T, K> operator()(std::size_t vertex) const {
    Vertex<S, T, K> v;
    std::size_t next = vertex * batch_.stride();
    for (int i = 0; i < v.kDimension; ++i) v.position[i] = scalar_from<T>(batch_.number(next++));
    const int planes = static_cast<int>(batch_.planes.size());
    v.attributes.resize(planes + batch_.attributes);
    for (int p = 0; p < planes; ++p) v.attributes[p] = distance(planes_.data() + 4 * p, v.position);
    for (int k = 0; k < batch_.attributes; ++k) {
      v.attributes[planes + k] = scalar_from<T>(batch_.number(next++));
    }
    return v;
  }

 private:
  static T distance(const T* n, const Vec3<T>& p) {
    return user_plane_distance(Vec4<T>(n[0], n[1], n[2], n[3]), p);
  }
  static T distance(const T* n, const Vec4<T>& p) {
    return n[0] * p[0] + n[1] * p[1] + n[2] * p[2] + n[3] * p[3];
  }

  const Batch& batch_;
  std::vector<T> planes_;
};

template <Scalar T>
Projection<T> projection_in(const Batch& batch) {
  Projection<T> projection = projection_from<T>(batch.frustum);
  projection.volume = batch.volume;
  projection.volume.clip_distances += static_cast<int>(batch.planes.size());
  return projection;
}

template <Scalar T>
PointSize<T> point_size_in(const Batch& batch) {
  if (!batch.point) return {};
  return point_size_ndc<T>(scalar_from<T>(batch.point->size),
                           scalar_from<T>(batch.point->viewport[0]),
                           scalar_from<T>(batch.point->viewport[1]));
}

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The loop of a C++ program over many triangles, which shares no code with the Python package's.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "spaces/clippers.hpp"

namespace clipscope::native {

// A polygon for each triangle, empty ones too; reused from call to call it allocates no more.
template <class T>
struct Polygons {
  std::vector<T> numbers;
  std::vector<std::int64_t> ends;
};

template <class T, int K>
void append(const NdcPolygon<T, K>& polygon, Polygons<T>& to, std::size_t& used) {
  const std::size_t needed = used + kMaxPolygonVertices * (4 + K);
  if (to.numbers.size() < needed) to.numbers.resize(2 * needed);
  for (const NdcVertex<T, K>& v : polygon) {
    for (int c = 0; c < 4; ++c) to.numbers[used++] = v.position[c];
    for (int k = 0; k < K; ++k) to.numbers[used++] = v.attributes[k];
  }
}

// Triangles of 3 or 4 + K numbers per vertex, one after the other, against projection or volume.
template <class C, Space S, class T, int K, class Against>
void clip_all(const T* from, std::size_t count, const Against& against, Polygons<T>& to) {
  std::size_t used = 0;
  to.ends.resize(count);
  NdcPolygon<T, K> polygon;
  for (std::size_t i = 0; i < count; ++i) {
    Triangle<S, T, K> triangle;
    for (auto& v : triangle) {
      for (int c = 0; c < v.kDimension; ++c) v.position[c] = *from++;
      for (int k = 0; k < K; ++k) v.attributes[k] = *from++;
    }
    C{}(against, triangle, polygon);
    append(polygon, to, used);
    to.ends[i] = static_cast<std::int64_t>(used / (4 + K));
  }
  to.numbers.resize(std::max(to.numbers.size(), used));
}

template <class T>
Projection<T> projection_of(const std::vector<double>& f, int depth, int clip_distances) {
  Frustum<double> frustum{ProjectionKind::perspective, f[0], f[1], f[2], f[3], f[4], f[5]};
  frustum.depth = static_cast<DepthRange>(depth);
  Projection<T> projection(frustum_cast<T>(frustum));
  projection.volume.clip_distances = clip_distances;
  return projection;
}

}  // namespace clipscope::native

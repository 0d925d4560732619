// SPDX-License-Identifier: GPL-3.0-or-later
//
// A batch's volume and frustum as the clippers take them.
#pragma once

#include "spaces/projection.hpp"
#include "spaces/vertex.hpp"
#include "spaces/volume.hpp"
#include "tests/spaces/attack/input.hpp"

namespace clipscope::attack {

inline DepthRange depth_range_of(Depth depth) {
  switch (depth) {
    case Depth::zero_to_one: return DepthRange::zero_to_one;
    case Depth::one_to_zero: return DepthRange::reversed;
    case Depth::minus_one_to_one: break;
  }
  return DepthRange::minus_one_to_one;
}

inline ClipVolume clip_volume_of(const Volume& v) {
  ClipVolume r;
  r.depth = depth_range_of(v.depth);
  r.depth_clamp = {v.clamps_near, v.clamps_far};
  r.clip_distances = v.clip_distances;
  r.open_sides = {v.is_open[0], v.is_open[1], v.is_open[2], v.is_open[3]};
  return r;
}

// Pre-condition: in view space.
inline Projection<float> projection_of(const Batch& batch) {
  const Frustum& f = *batch.frustum;
  clipscope::Frustum<float> frustum;
  frustum.kind = f.is_perspective ? ProjectionKind::perspective : ProjectionKind::parallel;
  frustum.left = f.left;
  frustum.right = f.right;
  frustum.bottom = f.bottom;
  frustum.top = f.top;
  frustum.near = f.near;
  frustum.far = f.far;
  frustum.infinite_far = f.is_infinite;
  frustum.shear_x = f.shear_x;
  frustum.shear_y = f.shear_y;
  frustum.depth = depth_range_of(batch.volume.depth);
  Projection<float> r(frustum);
  r.volume = clip_volume_of(batch.volume);
  return r;
}

// K: the number of attributes, or kRunTime.
template <Space S, int K>
Triangle<S, float, K> triangle_of(const Batch& batch, std::size_t t) {
  Triangle<S, float, K> r;
  for (std::size_t v = 0; v < 3; ++v) {
    const float* p = batch.vertex(t, v);
    for (std::size_t c = 0; c < batch.dimension(); ++c) r[v].position[static_cast<int>(c)] = *p++;
    r[v].attributes.resize(batch.attributes);
    for (int k = 0; k < batch.attributes; ++k) r[v].attributes[k] = *p++;
  }
  return r;
}

template <class Vertices>
std::vector<float> floats_of(const Vertices& polygon) {
  std::vector<float> r;
  for (const auto& v : polygon) {
    for (int c = 0; c < 4; ++c) r.push_back(v.position[c]);
    for (int k = 0; k < v.attributes.size(); ++k) r.push_back(v.attributes[k]);
  }
  return r;
}

}  // namespace clipscope::attack

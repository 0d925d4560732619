// SPDX-License-Identifier: MIT
//
// homogeneous/sutherland_hodgman as a plug-in: what a plug-in costs is measured with it, and its
// answers have the bits of the clipper's own.
#include <algorithm>
#include <type_traits>

#include "spaces/homogeneous/sutherland_hodgman.hpp"
#include "spaces/plugin/clipscope_plugin.h"

namespace {

using namespace clipscope;

constexpr int kUsualAttributes = 4;  // have code of their own; other numbers share some

DepthRange depth_of(const clipscope_task& task) {
  if (task.depth == CLIPSCOPE_DEPTH_ZERO_TO_ONE) return DepthRange::zero_to_one;
  if (task.depth == CLIPSCOPE_DEPTH_REVERSED) return DepthRange::reversed;
  return DepthRange::minus_one_to_one;
}

ClipVolume volume_of(const clipscope_task& task) {
  const auto has = [](std::uint32_t bits, std::uint32_t bit) { return (bits & bit) != 0; };
  ClipVolume volume{.depth = depth_of(task)};
  volume.depth_clamp = {has(task.depth_clamp, CLIPSCOPE_CLAMP_NEAR),
                        has(task.depth_clamp, CLIPSCOPE_CLAMP_FAR)};
  volume.clip_distances = static_cast<int>(task.clip_distances);
  volume.open_sides = {
      has(task.open_sides, CLIPSCOPE_OPEN_LEFT), has(task.open_sides, CLIPSCOPE_OPEN_RIGHT),
      has(task.open_sides, CLIPSCOPE_OPEN_BOTTOM), has(task.open_sides, CLIPSCOPE_OPEN_TOP)};
  return volume;
}

template <class T>
Projection<T> projection_of(const clipscope_task& task) {
  const double* m = task.matrix;
  const auto row = [&](int own, int i) {
    return ProjectionRow<T>{own < 0 ? T(0) : T(m[own]), T(m[4 * i + 2]), T(m[4 * i + 3])};
  };
  Projection<T> p;
  p.volume = volume_of(task);
  p.x = row(0, 0);
  p.y = row(5, 1);
  p.z = row(-1, 2);
  p.w = row(-1, 3);
  return p;
}

template <Space S, class T, int K>
void read(const T*& from, int attributes, Vertex<S, T, K>& v) {
  for (int i = 0; i < v.kDimension; ++i) v.position[i] = *from++;
  v.attributes.resize(attributes);
  for (int k = 0; k < attributes; ++k) v.attributes[k] = *from++;
}

template <class T, int K>
T* write(const NdcPolygon<T, K>& polygon, T* to) {
  for (const NdcVertex<T, K>& v : polygon) {
    for (int i = 0; i < 4; ++i) *to++ = v.position[i];
    for (int k = 0; k < v.attributes.size(); ++k) *to++ = v.attributes[k];
  }
  return to;
}

// Where: a projection or a volume.
template <Space S, int K, class T, class Where>
void clip_all(const Where& where, const clipscope_task& task, const T* from, T* to,
              std::size_t* ends) {
  const int attributes = K == kRunTime ? static_cast<int>(task.attributes) : K;
  Triangle<S, T, K> triangle;
  NdcPolygon<T, K> polygon;
  std::size_t written = 0;
  for (std::size_t i = 0; i < task.count; ++i) {
    for (auto& vertex : triangle) read(from, attributes, vertex);
    HomogeneousSutherlandHodgman{}(where, triangle, polygon);
    to = write(polygon, to);
    ends[i] = written += static_cast<std::size_t>(polygon.size());
  }
}

template <int K, class T>
void clip_in(const clipscope_task& task, const T* from, T* to, std::size_t* ends) {
  if (task.space == CLIPSCOPE_VIEW_SPACE) {
    clip_all<Space::view, K>(projection_of<T>(task), task, from, to, ends);
  } else {
    clip_all<Space::clip, K>(volume_of(task), task, from, to, ends);
  }
}

template <class T>
void clip_batch(const clipscope_task& task, const T* from, T* to, std::size_t* ends) {
  if (task.attributes == kUsualAttributes) return clip_in<kUsualAttributes>(task, from, to, ends);
  clip_in<kRunTime>(task, from, to, ends);
}

std::int32_t clip(const clipscope_task* task, clipscope_answer* answer) {
  if (task->scalar == CLIPSCOPE_FLOAT) {
    clip_batch(*task, task->floats, answer->floats, answer->ends);
  } else {
    clip_batch(*task, task->doubles, answer->doubles, answer->ends);
  }
  return CLIPSCOPE_DONE;
}

constexpr clipscope_plugin kPlugin = {
    sizeof(clipscope_plugin),
    CLIPSCOPE_PLUGIN_ABI,
    "plugin/sutherland_hodgman",
    "homogeneous/sutherland_hodgman as a plug-in",
    "Blinn and Newell, Clipping Using Homogeneous Coordinates, 1978",
    CLIPSCOPE_FLOAT | CLIPSCOPE_DOUBLE | CLIPSCOPE_VIEW_SPACE | CLIPSCOPE_CLIP_SPACE |
        CLIPSCOPE_TRIANGLES | CLIPSCOPE_DEPTH_MINUS_ONE_TO_ONE | CLIPSCOPE_DEPTH_ZERO_TO_ONE |
        CLIPSCOPE_DEPTH_REVERSED | CLIPSCOPE_OFF_CENTRE | CLIPSCOPE_INFINITE_FAR |
        CLIPSCOPE_ORTHOGRAPHIC | CLIPSCOPE_OBLIQUE | CLIPSCOPE_DEPTH_CLAMP |
        CLIPSCOPE_CLIP_DISTANCES | CLIPSCOPE_OPEN_SIDES | CLIPSCOPE_THREAD_SAFE,
    CLIPSCOPE_MOST_ATTRIBUTES,
    clip};

}  // namespace

const clipscope_plugin* clipscope_plugin_entry(std::uint32_t abi_version) {
  return abi_version == CLIPSCOPE_PLUGIN_ABI ? &kPlugin : nullptr;
}

// SPDX-License-Identifier: MIT
//
// A clipper as a plug-in of clipscope, in C++: it cuts against the near plane before the divide and
// against the other planes after it.
//
// Its bug is in every software rasteriser once: after the divide attributes are no longer linear on
// screen, but they are interpolated as if they were. Positions are right, textures swim at the
// border of the picture.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "clipscope_plugin.h"

namespace {

constexpr std::size_t kPosition = 4;

// x y z w before the divide, x y z 1/w after it; then attributes, 0 where there are fewer.
using Vertex = std::array<float, kPosition + CLIPSCOPE_MOST_ATTRIBUTES>;
using Polygon = std::vector<Vertex>;

Vertex between(const Vertex& a, const Vertex& b, float t) {
  Vertex v;
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = a[i] + t * (b[i] - a[i]);
  return v;
}

// The part where the distance is at least 0 (Sutherland and Hodgman, Reentrant Polygon Clipping,
// 1974). put_on_plane(v): rids a new vertex of its rounding error.
template <class Distance, class PutOnPlane>
Polygon cut(const Polygon& polygon, const Distance& distance, const PutOnPlane& put_on_plane) {
  Polygon out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vertex& a = polygon[i];
    const Vertex& b = polygon[(i + 1) % polygon.size()];
    const float d_a = distance(a), d_b = distance(b);
    if (d_a >= 0) out.push_back(a);
    if ((d_a >= 0) != (d_b >= 0)) {
      out.push_back(between(a, b, d_a / (d_a - d_b)));
      put_on_plane(out.back());
    }
  }
  return out;
}

void divide(Vertex& v) {
  for (std::size_t i = 0; i < 3; ++i) v[i] /= v[3];
  v[3] = 1 / v[3];
}

Polygon clipped(const Polygon& triangle) {
  Polygon polygon = cut(
      triangle, [](const Vertex& v) { return v[3] + v[2]; }, [](Vertex& v) { v[2] = -v[3]; });
  for (Vertex& v : polygon) {
    if (v[3] <= 0) return {};  // x = y = z = w = 0, or all of it in the eye
    divide(v);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      polygon = cut(
          polygon, [=](const Vertex& v) { return 1 - side * v[axis]; },
          [=](Vertex& v) { v[axis] = side; });
    }
  }
  return polygon;
}

bool is_finite(const Polygon& triangle) {
  return std::all_of(triangle.begin(), triangle.end(), [](const Vertex& v) {
    return std::all_of(v.begin(), v.begin() + kPosition, [](float x) { return std::isfinite(x); });
  });
}

std::int32_t clip(const clipscope_task* task, clipscope_answer* answer) {
  Polygon triangle(3);
  std::size_t end = 0;
  for (std::size_t i = 0; i < task->count; ++i) {
    for (std::size_t v = 0; v < 3; ++v) {
      std::copy_n(task->floats + (3 * i + v) * task->stride, task->stride, triangle[v].begin());
    }
    const Polygon polygon = is_finite(triangle) ? clipped(triangle) : Polygon();
    if (end + polygon.size() > answer->capacity) return CLIPSCOPE_FAILED;
    for (const Vertex& v : polygon) {
      std::copy_n(v.begin(), answer->stride, answer->floats + answer->stride * end++);
    }
    answer->ends[i] = end;
  }
  return CLIPSCOPE_DONE;
}

clipscope_plugin described() {
  clipscope_plugin plugin{};
  plugin.struct_size = sizeof plugin;
  plugin.abi_version = CLIPSCOPE_PLUGIN_ABI;
  plugin.name = "example/affine_attributes";
  plugin.summary = "near plane, divide, other planes; attributes are not perspective-correct";
  plugin.source = "an example, with a bug";
  plugin.capabilities = CLIPSCOPE_FLOAT | CLIPSCOPE_CLIP_SPACE | CLIPSCOPE_TRIANGLES |
                        CLIPSCOPE_DEPTH_MINUS_ONE_TO_ONE | CLIPSCOPE_THREAD_SAFE;
  plugin.most_attributes = CLIPSCOPE_MOST_ATTRIBUTES;
  plugin.clip = clip;
  return plugin;
}

}  // namespace

const clipscope_plugin* clipscope_plugin_entry(std::uint32_t abi_version) {
  static const clipscope_plugin plugin = described();
  return abi_version == CLIPSCOPE_PLUGIN_ABI ? &plugin : nullptr;
}

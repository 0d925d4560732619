// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is attacked with: triangles of floats that share a volume or a frustum.
//
// The types are this folder's own, so that the exact answer has nothing in common with spaces/ or
// reference/, not even how they spell a volume.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace clipscope::attack {

// The depth of the near plane, then that of the far plane.
enum class Depth { minus_one_to_one, zero_to_one, one_to_zero };

struct Volume {
  Depth depth = Depth::minus_one_to_one;
  bool clamps_near = false, clamps_far = false;  // these planes do not cut
  int clip_distances = 0;                        // so many of the first attributes, at most 8
  std::array<bool, 4> is_open = {};              // left, right, bottom, top do not own their points

  friend bool operator==(const Volume&, const Volume&) = default;
};

struct Frustum {
  bool is_perspective = true;
  float left = -1, right = 1, bottom = -1, top = 1, near = 1, far = 10;
  bool is_infinite = false;        // then `far` is of no matter; perspective only
  float shear_x = 0, shear_y = 0;  // parallel only

  friend bool operator==(const Frustum&, const Frustum&) = default;
};

// Triangles of a view space if there is a frustum, else of clip space.
struct Batch {
  Volume volume;
  std::optional<Frustum> frustum;
  int attributes = 0;
  // Vertices one after the other, three per triangle: x y z or x y z w, then the attributes.
  std::vector<float> floats;

  bool is_view() const { return frustum.has_value(); }
  std::size_t dimension() const { return is_view() ? 3 : 4; }
  std::size_t stride() const { return dimension() + static_cast<std::size_t>(attributes); }
  std::size_t triangles() const { return floats.size() / (3 * stride()); }
  float* vertex(std::size_t triangle, std::size_t v) {
    return floats.data() + (3 * triangle + v) * stride();
  }
  const float* vertex(std::size_t triangle, std::size_t v) const {
    return floats.data() + (3 * triangle + v) * stride();
  }
  // Triangle `t` alone.
  Batch only(std::size_t t) const {
    Batch r{volume, frustum, attributes, {}};
    r.floats.assign(vertex(t, 0), vertex(t, 0) + 3 * stride());
    return r;
  }
};

}  // namespace clipscope::attack

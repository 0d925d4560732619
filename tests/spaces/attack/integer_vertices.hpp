// SPDX-License-Identifier: GPL-3.0-or-later
//
// The floats of a triangle as integers, times 2^149.
#pragma once

#include "tests/spaces/attack/integer_clip.hpp"

namespace clipscope::attack {

// 2^149: a 1 in the scale of a float.
inline Integer one() { return Integer(1) << kFloatScale; }

// A triangle's floats as integers.
class Vertices {
 public:
  Vertices(const Batch& batch, std::size_t triangle) : batch_(batch), triangle_(triangle) {}

  // Float number k of the three vertices.
  Weights floats(std::size_t k) const {
    return {scaled(batch_.vertex(triangle_, 0)[k]), scaled(batch_.vertex(triangle_, 1)[k]),
            scaled(batch_.vertex(triangle_, 2)[k])};
  }
  Weights attribute(int k) const {
    return floats(batch_.dimension() + static_cast<std::size_t>(k));
  }
  // f of the coordinates of each vertex, x y z or x y z w.
  template <class F>
  Weights of_each(F&& f) const {
    Weights r;
    for (std::size_t v = 0; v < 3; ++v) {
      const float* p = batch_.vertex(triangle_, v);
      r[v] =
          f(scaled(p[0]), scaled(p[1]), scaled(p[2]), batch_.is_view() ? Integer() : scaled(p[3]));
    }
    return r;
  }

 private:
  const Batch& batch_;
  std::size_t triangle_;
};

// The w of clip space at the vertices.
Weights w_of(const Batch& batch, const Vertices& vertices);

}  // namespace clipscope::attack

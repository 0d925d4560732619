// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangle soups: random view-space triangles in chosen shares of inside, outside and straddling.
//
// What is guaranteed: the shares (exact up to rounding to whole triangles), and that every vertex
// keeps a distance from every plane of the volume and from w = 0 that is more than 1e-5 of its own
// magnitude, so that a float computation classifies it as exact arithmetic does.
// What is not: that the sizes follow any particular game. An inside triangle is 1 to 100 px large at
// 3840 x 2160, a straddling one 16 to 400 px; near-plane crossers are as large as the near rectangle.
#pragma once

#include <cstddef>
#include <cstdint>

#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

// How many of the triangles are of which kind, as non-negative weights of any positive sum.
struct SoupShares {
  double inside = 0;       // all vertices inside the volume
  double outside = 0;      // all vertices outside one plane: rejected by outcodes
  double straddling = 0;   // one vertex or two inside, and every one in front of the eye (w > 0)
  double crossing_w0 = 0;  // one vertex or two inside, and one or two behind the eye (w < 0)
};

enum class SoupClass { inside, outside, straddling, crossing_w0, none };

// The class of a triangle by a plain double computation; `none` where a vertex comes too close to a
// plane or the triangle belongs to no class. In a parallel projection nothing crosses w = 0.
SoupClass classify(const Frustum<float>& frustum,
                   const std::array<std::array<float, 3>, 3>& triangle);

// `triangles` triangles with three vertices of their own each, the classes in random order.
// Attributes: u, v in [0, 1], the two others in [-1, 1].
// Errors: UsageError for a negative share, shares that sum to 0, crossing_w0 > 0 with a parallel
// projection, and a volume so thin that a million proposals of a class found no triangle. Pre-condition: is_valid(frustum).
Mesh make_soup(const SoupShares& shares, std::size_t triangles, std::uint64_t seed,
               const Frustum<float>& frustum);

}  // namespace clipscope::experiments

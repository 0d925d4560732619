// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far from exact a right driver may be: the constants, and why.
//
// Snapping. A driver keeps window coordinates in b sub-pixel bits (GL_SUBPIXEL_BITS,
// subPixelPrecisionBits), so that each vertex of the polygon that it fills, also one made by
// clipping, is less than u = 2^-b px away from its place in x and in y, however it rounds.
//
//   Lemma. Let Q be a convex polygon, Q' the same with each vertex moved by at most u in x and y.
//   A point whose square of half side u lies in Q is in Q', on the same side of the same winding; a
//   point whose square lies outside of Q is outside of Q'.
//   Proof. Triangulate Q; the piecewise linear map onto Q' moves each point by at most u in x and y
//   (a convex combination of moves). The borders are homotopic along it, and no stage of the
//   homotopy meets the point, so that both borders wind around it equally often.
//
// For an edge of Q with the function L, linear in px, the square lies on the edge's inner side if
// L >= u (|dL/dx| + |dL/dy|). It lies outside of Q if L <= -u (|dL/dx| + |dL/dy|) for one edge.
// With orientation kept inside of Q, the same holds for the sign of the area.
// In values: Q' at a point p has the exact value of Q at some point less than u away from p in x
// and in y, since both are the same combination of the same vertices' values.
//
// Arithmetic. OpenGL (4.6 core, 2.3.4.1; ES 3.2, 2.3.4.1): "individual results of floating-point
// operations are accurate to about 1 part in 10^5", magnitudes up to 2^32. Vulkan 1.3 says nothing
// beyond the sub-pixel bits of fixed-function arithmetic; it gets the same, since drivers of both
// share it. A vertex takes kTransform operations to the window: a division, a product, a sum. Where
// clipping makes it, there are kClip before them: two distances, their difference, a division,
// 1 - t, two products and a sum. Each result is that of exact arithmetic on clip coordinates that
// are changed by as much, relatively; of a vertex made between two others it is the same line
// between two changed vertices. A function V_j x V_k . P then changes by at most twice that, times
// the same expression with all terms positive; window coordinates are further rounded relative to
// their own size, which is at most that of the viewport's farthest corner.
//
// What is beyond both is a violation; what is beyond the first alone is legal, but inexact.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "experiments/drawcalls/driver.hpp"

namespace clipscope::experiments {

inline constexpr double kEpsilon = 1e-5;
inline constexpr int kTransform = 3;
inline constexpr int kClip = 8;
// Of a value that is interpolated: two products, a sum and a product for each weight, their sums,
// the division by them; of 1/w or z the transform before that.
inline constexpr int kInterpolation = 8;
// Beyond it, or below its inverse, nothing is promised of a number.
inline constexpr double kGreatest = 0x1p32;
inline constexpr double kLeastNormal = 0x1p-126;

// How far a vertex may be from its exact place in x and in y because of snapping, px.
inline double snap_px(const DriverInfo& info) { return std::ldexp(1.0, -info.subpixel_bits); }

// The greatest window coordinate in the viewport, px.
inline double farthest_px(const Viewport& port) {
  return std::max({std::abs(port.x), std::abs(port.y), std::abs(port.x + port.width),
                   std::abs(port.y + port.height)});
}

// Operations on a vertex, as above.
inline int operations(bool is_clipped) { return kTransform + (is_clipped ? kClip : 0); }

}  // namespace clipscope::experiments

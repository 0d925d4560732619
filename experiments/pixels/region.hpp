// SPDX-License-Identifier: GPL-3.0-or-later
//
// Region: which pixels a primitive must cover, which it must not, and where both are right.
//
// A region is an intersection of half-planes of the window, each with the margins of accuracy.hpp;
// what all of them contain by more than their margins is covered. Everything is in double: its
// error is far below the margin that arithmetic of 1 part in 10^5 gets.
//
// A triangle's half-planes are its three edges, the depths unless they are clamped, and the clip
// distances, all as they are at w > 0; the viewport is an exact rectangle, since pixel centres are
// half a px from its borders. A triangle without an area has both sides of the line that it lies on
// as half-planes, and covers nothing for certain; if part of it is at w <= 0, all is left open. A
// point has the four sides of its square.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "experiments/pixels/accuracy.hpp"

namespace clipscope::experiments {

// By what is certain: the outer two whatever the arithmetic, the next two by the sub-pixel bits
// alone.
enum class Coverage : std::uint8_t { outside, nearly_outside, undecided, nearly_covered, covered };

// >= 0 is inside: a x + b y + c at the centre of the pixel in column x and row y.
struct HalfPlane {
  double a = 0, b = 0, c = 0;
  double snap = 0;   // margin for the sub-pixel bits
  double slack = 0;  // and what arithmetic adds to it

  double at(int x, int y) const { return a * x + b * y + c; }
  double margin() const { return snap + slack; }
};

struct PixelBox {
  int left = 0, right = 0, bottom = 0, top = 0;  // columns left to right - 1, rows likewise
  bool contains(int x, int y) const { return left <= x && x < right && bottom <= y && y < top; }
};

struct Region {
  // Of a triangle with an area the first three are the edges opposite to vertex 0, 1 and 2.
  std::vector<HalfPlane> half_planes = {};
  PixelBox box = {};           // outside of it all is `outside`
  bool is_degenerate = false;  // nothing is covered for certain
  bool is_discarded = false;   // nothing may be drawn: all is outside
  bool is_inside = true;       // all vertices are in the clip volume
  // Where a point reaches beyond the viewport drivers differ: nothing is covered for certain.
  PixelBox certain = {};
  double displacement_px = 0;  // of a vertex: snapping and arithmetic
};

// The sign of its determinant is that of ExactPrimitive::orientation.
Region triangle_region(const DrawCall& call, std::span<const std::uint32_t> vertices,
                       const DriverInfo& info, int orientation);

// Whether a point is drawn that lies beside the view volume is left open by OpenGL, and by us where
// OpenGL ES has changed its mind (3.0, 3.2); Vulkan says it by pointClippingBehavior.
Region point_region(const DrawCall& call, std::uint32_t vertex, const DriverInfo& info);

// The pixels that target and viewport have in common.
PixelBox visible_box(const DrawCall& call);

// Whether the vertex is in the clip volume, borders included: no rounding.
bool is_in_volume(const DrawVertex& vertex, const ClipVolume& volume);

// The pixel's distance from the half-plane that it is least inside of, in multiples of its margin:
// at least 1 is covered, below -1 outside.
double standing_at(const Region& region, int x, int y);

Coverage coverage_at(const Region& region, int x, int y);

// Of columns box.left to box.right - 1 in row y.
void coverage_of_row(const Region& region, int y, std::vector<Coverage>& row);

}  // namespace clipscope::experiments

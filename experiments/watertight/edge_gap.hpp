// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is left of a shared edge in the polygons of its two triangles: the same bits, or a gap.
//
// The vertices of a polygon that lie on an edge are found by marks, as attributes: one per edge is
// 0 at the ends of the edge and a mark at the corner opposite to it. Every clipper interpolates 0
// and 0 to 0, and NaN marks whatever it touches. A barycentric clipper multiplies the mark by 0 on
// the edge, so there it is 1: its weight of that corner is exactly 0 on the edge, and not 0 off it.
//
// Distances are computed in double from differences taken in the clipper's scalar: they are right
// to 1e-12 px (2^-52 of a coordinate up to 1, times half of 3840 px), and 0 where the bits are the
// same.
#pragma once

#include <array>

#include "experiments/contestants/contestant.hpp"

namespace clipscope::experiments::watertight {

// The triangle with its three edges marked for the contestant. Its first attribute is its x
// coordinate: whatever neighbours have in common depends on the position alone.
SceneTriangle marked(const SceneTriangle& triangle, const Contestant& contestant);

// A marked triangle's polygon, and the corner opposite to the edge.
struct EdgeSide {
  PolygonView polygon;
  int opposite = 0;
  double width_px = 0;  // how far from the edge it should reach, see CutEdge
};

// Nothing is left of a triangle whose polygon is empty, or flat: all of its vertices on the edge.
// It is where less is visible of it than rounding can tell.
struct EdgeGap {
  bool identical = false;  // the same vertices, bit for bit: x, y, z, 1/w and an attribute
  bool absent = false;     // identical, since neither polygon has anything of the edge
  bool lost = false;       // nothing is left of one triangle, while the other one has the edge
  int t_junctions = 0;     // vertices on the edge without a partner in the other polygon; 0 if lost
  double lost_px = 0;      // how long the piece is that only one side has; 0 if it is a point
  double crack_px = 0;     // largest distance from such a vertex to the other polygon's outline
  std::array<double, 2> at = {0, 0};  // that vertex: x, y in NDC
};

EdgeGap edge_gap(const EdgeSide& first, const EdgeSide& second);

}  // namespace clipscope::experiments::watertight

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangulates a simple polygon, concave or convex, before it is clipped: what a concave polygon
// leaves of itself in a convex volume may be several polygons, but each of its triangles leaves at
// most one.
//
// Method: constrained Delaunay triangulation of the polygon's projection on the coordinate plane in
// which its area is largest: dropping coordinates rounds nothing, and predicates are exact. CGAL
// User Manual, "2D Triangulations". That plane belongs to the largest component of the normal as
// Newell has it: Tampieri, "Newell's Method for Computing the Plane Equation of a Polygon",
// Graphics Gems III, 1992. In clip space, which has four coordinates, there are six such planes
// instead of three.
// Guarantees: n - 2 triangles over the polygon's own n vertices and no others, in its winding, that
// tile its projection; every edge of the polygon is an edge of one triangle.
// Does not guarantee: that the polygon is planar. One that is not is triangulated as its projection
// is.
#pragma once

#include <array>
#include <concepts>
#include <span>
#include <string>
#include <vector>

#include "spaces/vertex.hpp"

namespace clipscope::experiments {

// Three indices of the polygon's vertices, in its winding.
using IndexTriangle = std::array<int, 3>;

// Points of three or four coordinates, in order around the polygon. `where` is the file and line,
// or whatever else tells the polygon from others; it opens the message of an InputError, which says
// what is wrong: fewer than three vertices, a coordinate that is not finite, no area, or edges that
// cross or touch.
std::vector<IndexTriangle> triangulate(std::span<const std::array<double, 3>> points,
                                       const std::string& where = "polygon");
std::vector<IndexTriangle> triangulate(std::span<const std::array<double, 4>> points,
                                       const std::string& where = "polygon");

// Indices of the vertices of a convex polygon that is all or part of another, in its winding.
using IndexPolygon = std::vector<int>;

// What a clipper of convex polygons can take: the whole polygon where it is convex (straight angles
// are), else its triangles. Errors as above.
std::vector<IndexPolygon> convex_parts(std::span<const std::array<double, 3>> points,
                                       const std::string& where = "polygon");
std::vector<IndexPolygon> convex_parts(std::span<const std::array<double, 4>> points,
                                       const std::string& where = "polygon");

// The triangles of vertices, whose attributes stay with them.
template <Space S, std::floating_point T, int K>
std::vector<IndexTriangle> triangulate(std::span<const Vertex<S, T, K>> polygon,
                                       const std::string& where = "polygon") {
  constexpr int kDimension = Vertex<S, T, K>::kDimension;
  std::vector<std::array<double, kDimension>> points(polygon.size());
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    for (int c = 0; c < kDimension; ++c) {
      points[i][static_cast<std::size_t>(c)] = polygon[i].position[c];
    }
  }
  return triangulate(std::span<const std::array<double, kDimension>>(points), where);
}

}  // namespace clipscope::experiments

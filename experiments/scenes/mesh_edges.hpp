// SPDX-License-Identifier: GPL-3.0-or-later
//
// The edges of a mesh, and what is wrong with them before anybody clips: places where a picture
// cracks however it is clipped.
//
// Vertices are one where their coordinates are equal, whether they have one index or several, so
// that seams of texture coordinates are none.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

// One side of an edge: a triangle beside it, and that triangle's corner (0 to 2) that is not on it.
// ends: the lowest indices of these positions, in ascending order.
struct HalfEdge {
  std::array<std::uint32_t, 2> ends;
  std::uint32_t triangle;
  int opposite;

  friend auto operator<=>(const HalfEdge&, const HalfEdge&) = default;
};

// The corners of a triangle, 0 to 2, that are not opposite to the edge.
constexpr std::array<std::size_t, 2> ends_of(int opposite) {
  const auto k = static_cast<std::size_t>(opposite);
  return {(k + 1) % 3, (k + 2) % 3};
}

// All of them, sorted, so that the sides of one edge stand together. Edges whose ends coincide are
// left out.
std::vector<HalfEdge> half_edges(const Mesh& mesh);

// Calls f(sides) for each edge, with the span of its sides.
template <class F>
void for_each_edge(std::span<const HalfEdge> sides, const F& f) {
  while (!sides.empty()) {
    std::size_t n = 1;
    while (n < sides.size() && sides[n].ends == sides[0].ends) ++n;
    f(sides.first(n));
    sides = sides.subspan(n);
  }
}

// What a mesh is like at its edges.
//
// A vertex lies on an edge, and two vertices are one but for rounding, where they are no farther
// apart than r = sqrt(3) 2^-23 M, M the largest of the coordinates: a point on the edge between two
// vertices, all three rounded to float, each coordinate by at most 2^-24 M, can come to lie so far
// off it.
struct MeshEdges {
  std::int64_t edges = 0;
  std::int64_t open = 0;                // beside one triangle
  std::int64_t crowded = 0;             // beside more than two
  std::int64_t repeated_triangles = 0;  // with the three positions of a triangle before
  // Ends of open edges that lie within another open edge: T-junctions. And the farthest of them
  // from the edge, in the mesh's units: 0 if each lies on it exactly.
  std::int64_t t_junctions = 0;
  double t_distance = 0;
  // Open edges beside another one whose ends are the same but for rounding.
  std::int64_t split = 0;

  // Whether a picture may crack at its edges however it is clipped.
  bool may_crack() const { return crowded + repeated_triangles + t_junctions + split > 0; }
};

MeshEdges edges_of(const Mesh& mesh);

// "12 T-junctions, up to 3.1e-08 off the edge; 3 edges of more than two triangles": what may crack;
// empty if nothing does.
std::string crack_text(const MeshEdges& edges);

}  // namespace clipscope::experiments

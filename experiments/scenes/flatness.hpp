// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far the vertices of a polygon are off one plane, decided exactly.
#pragma once

#include <array>
#include <span>

namespace clipscope::experiments {

// The vertex farthest off the plane, and by how much, in the units of the coordinates.
struct Departure {
  int vertex = 0;
  double distance = 0;  // 0 only where all vertices lie in one plane

  bool is_flat() const { return distance == 0; }
};

// The plane (of R^3 or, in clip space, of R^4) goes through vertex 0, the vertex farthest from it,
// and the one farthest from the line through these two. Distances are compared exactly; the
// largest is rounded at the end, and never to 0. Vertices on one line are flat.
// Pre-condition: the coordinates are finite.
Departure departure_from_plane(std::span<const std::array<double, 3>> points);
Departure departure_from_plane(std::span<const std::array<double, 4>> points);

}  // namespace clipscope::experiments

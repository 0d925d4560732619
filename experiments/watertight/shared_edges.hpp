// SPDX-License-Identifier: GPL-3.0-or-later
//
// Edges that two triangles of a mesh share, and those of them that clipping touches in a view.
//
// Two triangles share an edge if its ends have the same coordinates, whether by index or by value,
// so that seams of texture coordinates count. Which edges clipping touches is decided exactly.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "experiments/scenes/scene.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments::watertight {

struct SharedEdge {
  std::array<std::uint32_t, 2> triangles;
  std::array<int, 2> opposite;  // the corner of each triangle, 0 to 2, that is not on the edge
};

// All of them, sorted. Where more than two triangles meet, the first is paired with each of the
// others. Edges whose ends coincide are left out.
std::vector<SharedEdge> shared_edges(const Mesh& mesh);

struct CutEdge {
  SharedEdge edge;
  Outcode planes = 0;                 // that cut the edge itself; 0: all of it is inside
  bool different_neighbours = false;  // the two triangles are not outside of the same planes
  // How far what is truly visible of each triangle reaches from the edge, px on 3840 x 2160: as
  // wide at most is what can show through where that triangle should be. Right to 1e-11 px.
  std::array<double, 2> width_px = {0, 0};
};

// The edges on which the clipped neighbours should meet, evenly spaced, at most `limit`; 0: all.
// Part of the edge is visible, more than a point; one of the neighbours at least is cut; and no
// plane holds the whole edge, since a neighbour beyond that plane rightly keeps nothing.
std::vector<CutEdge> cut_edges(const Scene& scene, const View& view,
                               const std::vector<SharedEdge>& edges, std::size_t limit);

// Items at equal steps, from the first on, at most `limit`; 0: all.
template <class T>
std::vector<T> at_most(std::size_t limit, const std::vector<T>& items) {
  return limit == 0 ? items : evenly_spaced(items, limit);
}

}  // namespace clipscope::experiments::watertight

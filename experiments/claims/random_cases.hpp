// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random input for exact counting: coordinates on coarse lattices, so that vertices fall on planes, on each
// other and on w = 0 as often as between them.
#pragma once

#include <array>
#include <vector>

#include "experiments/contestants/scalars.hpp"
#include "experiments/scenes/random.hpp"
#include "reference/truth.hpp"
#include "spaces/projection.hpp"

namespace clipscope::experiments {

// Perspective, off-centre or parallel, with small numbers; depth [-1, 1].
Frustum<double> random_frustum(Random& random);

// Around those frusta: |x|, |y| <= 8, -12 <= z <= 2, in quarters.
reference::InputVertex lattice_view_vertex(Random& random);
reference::InputTriangle lattice_view_triangle(Random& random);

// |x|, |y|, |z|, |w| <= 3, in halves: w of both signs and 0.
reference::InputTriangle lattice_clip_triangle(Random& random);

// Vertex 0 outside of exactly one plane of the volume, vertices 1 and 2 inside of all; w = 1, 2 or 3.
reference::InputTriangle one_vertex_outside(Random& random);
// The coordinate in which a vertex is outside. Pre-condition: it is, in one.
int outside_axis(const reference::InputVertex& v);

// Near the plane x + y + z = 0, which cuts the volume in a hexagon: of a size such that each edge cuts
// off a corner of the hexagon if the random shifts are small.
reference::InputTriangle hexagon_cutter(Random& random);

// 3 to 8 vertices on a circle in a random plane, about as large as the volume; w > 0 varies over it.
std::vector<ClipVertex<Exact, 0>> convex_clip_polygon(Random& random);

// A star of 4 to 7 points about a random centre, in the plane z = 0.
std::vector<std::array<double, 3>> star_polygon(Random& random);

// The same bits as exact numbers.
Frustum<Exact> exact_frustum(const Frustum<double>& frustum);
ViewSegment<Exact, 1> exact_view_segment(const std::array<reference::InputVertex, 2>& segment);
ViewTriangle<Exact, kRunTime> exact_view_triangle(const reference::InputTriangle& triangle);
ClipTriangle<Exact, kRunTime> exact_clip_triangle(const reference::InputTriangle& triangle);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Gold: the clipped triangle by CGAL's polyhedra in exact arithmetic, independent of the fast
// reference in everything but the types: own matrices, own planes, rationals instead of fractions.
//
//   frustum   the convex hull of the frustum's eight corners, as a Nef polyhedron, intersected with
//             the triangle, as a Nef facet. An infinite far plane is put beyond the triangle, and
//             so are near and far with depth clamp (in perspective near is then the eye).
//   matrix    the half-spaces w + x >= 0 and so on as view-space planes, each cut out of a cube
//             around the triangle and intersected with the triangle
//   clip      the same in the plane of the barycentric coordinates (l1, l2), where the half-spaces
//             of clip space are half-planes and w may have any sign
//
// An open side takes the closed half-space beyond it away from that; the closure is the result.
//
// A clip distance is the half-space of view space, or of the plane of (l1, l2), whose form takes
// the attribute's values at the triangle's vertices.
//
// Sources: Hachenberger, Kettner and Mehlhorn, "Boolean Operations on 3D Selective Nef Complexes",
// 2007; CGAL's 3D Convex Hulls (convex_hull_3, halfspace_intersection_3).
//
// The result is the set of vertices, sorted, as `vertex_set` gives it for the fast reference: the
// two must be equal as rational numbers.
//
// Pre-conditions: is_finite(triangle), checked by assertion; and that the triangle has an area in
// NDC: three clip positions on a plane through the origin throw std::invalid_argument, since the
// facet of such a triangle isn't one, or its vertices collapse. An invalid frustum or matrix throws
// too. There is no gold for points, segments and other polygons.
#pragma once

#include <vector>

#include "reference/exact_clip.hpp"
#include "spaces/projection.hpp"

namespace clipscope::reference {

std::vector<RationalVertex> gold_of_frustum(const Frustum<double>& frustum,
                                            const InputTriangle& triangle);
std::vector<RationalVertex> gold_of_frustum(const Frustum<double>& frustum,
                                            const ClipVolume& volume,
                                            const InputTriangle& triangle);
std::vector<RationalVertex> gold_of_matrix(const Projection<float>& projection,
                                           const InputTriangle& triangle);
std::vector<RationalVertex> gold_of_clip(DepthRange depth, const InputTriangle& triangle);
std::vector<RationalVertex> gold_of_clip(const ClipVolume& volume, const InputTriangle& triangle);

}  // namespace clipscope::reference

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The planes of a view in world space, for holding bounding volumes that never move against a camera that
// does: made once per view, so that an object costs its test and nothing else.
//
// Rounding. What is clipped are view-space vertices v = R p + t, computed in double and rounded to float,
// then transformed by the projection's float matrix. Let W be a plane's sum of magnitudes at v
// (spaces/bounds/culling_planes.hpp) and u = 2^-23. Then, from the exact frustum to what a float clipper
// sees, each plane's signed distance is off by at most
//   W u / 2   rounding v to float (what double adds is 2^-29 of that),
//   6 W u     the matrix's entries, each a few roundings away from the frustum's, both rows of a plane,
//   W u       the plane itself, a rounded sum of two rows,
//   12 W u    the clipper's transform in float, in any order of summation,
// 20 W u in all. In world space W is taken as |n| |R| |p| + |n| |t| + |offset|, which is never less. The
// planes are given in double with weights 2^30 times as large, so that the error that visibility() allows
// for is 16 * 2^-52 * 2^30 W = 32 u W.
//
// Guarantees, for boxes and spheres that contain the world-space positions of an object: rejected means
// that no triangle of it is visible in exact arithmetic (reference::Truth::of_frustum), and that each
// has all its outcodes in common in float clip space; accepted means that all of it is inside in both
// senses: projecting it is all that is left to do.
// Does not guarantee: anything for a view whose matrix is not a rotation and a shift.
#pragma once

#include "experiments/scenes/scene.hpp"
#include "spaces/bounds/culling_planes.hpp"

namespace clipscope::experiments {

CullingPlanes<double> world_planes(const View& view);

}  // namespace clipscope::experiments

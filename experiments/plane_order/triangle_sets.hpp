// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sets of clip-space triangles that some plane cuts and none rejects.
//
// Clip-space floats are the input: the question is about the cuts, so the rounding of the transform is
// none of its errors. All of a set is seen in one depth range.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "experiments/commands/selection.hpp"
#include "experiments/scenes/scene.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments {

struct CutTriangle {
  ClipTriangle<float, kSceneAttributes> triangle;
  Outcode planes = 0;  // that some vertex is outside of
};

struct TriangleSet {
  std::string name;
  DepthRange depth = DepthRange::minus_one_to_one;
  std::vector<CutTriangle> triangles;
};

// The sets' names: the selected scenes, or soups, slivers, floor and corridor; then
//   mixed_w     random homogeneous coordinates in [-2, 2], w too
//   lattice     random integers in {-2, ..., 2}: many vertices on planes, at w = 0, triangles without area
//   hard_cases  the triangles of the catalogue in clip space, depth -1 to 1
std::vector<std::string> set_names(const Selection& selection);

// At most `limit` triangles, evenly spaced or the first drawn. Errors: UsageError, InputError.
TriangleSet make_set(const Selection& selection, const std::string& name, std::size_t limit);

}  // namespace clipscope::experiments

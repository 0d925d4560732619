// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a planned pipeline changes against the full one.
#pragma once

#include <span>

#include "experiments/scenes/scene.hpp"
#include "spaces/effects/plan.hpp"

namespace clipscope::experiments {

struct Harm {
  std::size_t polygons = 0;  // compared
  // Polygons of which some bit differs: of x, y and the attributes; of z if the plan has depth; of 1/w
  // if it has perspective correction.
  std::size_t changed = 0;
  // The largest difference of an attribute between perspective-correct and affine interpolation that
  // was found within a polygon; 0 with perspective correction. A lower bound: edges are searched at
  // their worst point, insides at the points of a grid.
  double attribute_error = 0;
};

Harm harm_of(const Plan<float>& plan, std::span<const SceneTriangle> triangles);

}  // namespace clipscope::experiments

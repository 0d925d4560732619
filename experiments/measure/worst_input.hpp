// SPDX-License-Identifier: GPL-3.0-or-later
//
// The record of a scene's triangle that a contestant is farthest off on.
#pragma once

#include <cstddef>
#include <string>

#include "experiments/commands/selection.hpp"
#include "experiments/contestants/contestant.hpp"
#include "experiments/scenes/scene.hpp"
#include "experiments/store/cell_record.hpp"

namespace clipscope::experiments {

struct WorstTriangle {
  const View& view;
  const SceneTriangle& triangle;
  std::size_t number;   // in the scene's mesh
  std::string measure;  // what `error` is, with its unit
  double error;
};

// With the triangle as hex floats and the command that shows it.
WorstInput worst_input(const Selection& selection, const Scene& scene,
                       const AnyContestant& contestant, const WorstTriangle& worst);

}  // namespace clipscope::experiments

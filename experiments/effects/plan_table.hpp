// SPDX-License-Identifier: GPL-3.0-or-later
//
// A plan as people read it: effect, called for?, because.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "experiments/effects/planned_scene.hpp"

namespace clipscope::experiments {

struct PlanLine {
  std::string effect;
  // "no", "yes"; of a plane "no", "test" (what is outside is dropped, nothing is cut), "scissor" (left
  // to a guard band) or "cut".
  std::string called_for;
  std::string because;
  int rank = 0;  // 0 for "no"; the more, the more work
};

// One line per effect, always the same effects in the same order.
std::vector<PlanLine> plan_lines(const PlannedView& view);

// The lines of all views of a scene as one: of each effect the line of the view that calls for most,
// with the number of views that call for it.
std::vector<PlanLine> plan_lines(std::span<const PlannedView> views);

// The effects that some view calls for, in few words: "near, sides, w, 1/w".
std::string called_for_in_short(std::span<const PlannedView> views);

}  // namespace clipscope::experiments

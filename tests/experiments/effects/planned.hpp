// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small scenes, planned.
#pragma once

#include "experiments/effects/plan_table.hpp"

namespace clipscope::experiments::effects {

inline std::vector<PlannedView> planned(const std::string& name,
                                        const PlanSettings& settings = {}) {
  Selection selection;
  selection.quick = true;
  return plan_views(load_needed_scene(selection, name), settings, 0);
}

}  // namespace clipscope::experiments::effects

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tables of the experiment, and what is made of their rows.
#pragma once

#include <string>

#include "experiments/effects/harm.hpp"
#include "experiments/effects/time_planned.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/report/table.hpp"

namespace clipscope::experiments {

struct EffectTables {
  EffectTables();

  // A row of `times`. timing: null if the pipeline was not timed because its answers are wrong.
  void add_row(const std::string& scene, const std::string& called_for, const Harm& harm,
               const PlannedTiming* timing);
  void add_notes(double tolerance, const std::string& machine);

  Table times, plans;
};

// Bars by scene: the full pipeline, the planned one, transform and divide alone.
Plot plot_of(const Table& times);

std::string finding_of(const Table& times);

}  // namespace clipscope::experiments

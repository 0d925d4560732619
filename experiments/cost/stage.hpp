// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stage's part of cost: mixes x clippers x contracts, and how their time grows.
#pragma once

#include <string>

#include "experiments/experiment.hpp"

namespace clipscope::experiments {

// Emits the tables and plots of the stage; returns its finding.
std::string run_stage(const ExperimentContext& context);

}  // namespace clipscope::experiments

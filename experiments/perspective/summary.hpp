// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tables of `perspective` come to: the plot over the ratio of w, and the finding. From rows alone.
#pragma once

#include <string>

#include "experiments/perspective/tables.hpp"
#include "experiments/report/plot.hpp"

namespace clipscope::experiments {

// Error over w_max / w_min - 1: the bound, what was measured, and lines at the errors that can be seen.
Plot error_over_ratio(const PerspectiveTables& tables);

// The answer to the experiment's question. Rows that were not asked for are not spoken of.
std::string perspective_finding(const PerspectiveTables& tables);

}  // namespace clipscope::experiments

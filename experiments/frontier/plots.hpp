// SPDX-License-Identifier: GPL-3.0-or-later
//
// Error over time, one plot per set, contract and measure: the frontier as a line, who is dominated in grey.
#pragma once

#include <string>

#include "experiments/frontier/contest.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/report/table.hpp"

namespace clipscope::experiments {

// From the rows of `frontier`; an error of 0 is drawn on the bottom line. Named along the frontier are
// the fastest for each error; of the dominated, in the full contract one well-known clipper per space in
// float and the batch clippers, in the stage all. All names are in the table.
Plot frontier_plot(const std::string& set, ErrorMeasure measure, const Table& frontier,
                   const std::string& contract = "full");

}  // namespace clipscope::experiments

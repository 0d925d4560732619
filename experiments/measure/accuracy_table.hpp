// SPDX-License-Identifier: GPL-3.0-or-later
//
// The columns that tell a clipper's accuracy, shared by every table that does.
#pragma once

#include <vector>

#include "experiments/measure/accuracy.hpp"
#include "experiments/report/table.hpp"

namespace clipscope::experiments {

// Clipper, scalar, counts by outcome, errors.
std::vector<Column> accuracy_columns();
std::vector<Cell> accuracy_cells(const AnyContestant& contestant, const AccuracyTally& tally);

// What the columns mean.
void add_accuracy_notes(Table& table);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tables of cost, and what is made from their rows: plots and the finding.
#pragma once

#include <span>
#include <string>

#include "experiments/cost/split.hpp"
#include "experiments/measure/timing.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/report/table.hpp"

namespace clipscope::experiments {

Table cost_table();             // mix, clipper, scalar: time, and ratio to textbook
Table cost_operations_table();  // mix, clipper: operations per triangle by kind
Table cost_split_table();       // mix, clipper, scalar, part: time, and share of the whole

void add_cost_rows(const std::string& mix, std::span<const AnyContestant> contestants,
                   std::span<const Timing> timings, Table& table);
// Runs the selected clippers in the counting scalar; those that there are in it.
void add_operation_rows(const std::string& mix, std::span<const TimedBatch> batches,
                        std::span<const AnyContestant> selected, Table& table);
void add_split_rows(const std::string& mix, std::span<const Split> splits, Table& table);

// Time by mix for one clipper of each space, in float if that is there.
Plot cost_plot(const Table& times);
// Parts by clipper for the first mix, in float if that is there. Pre-condition: rows.
Plot split_plot(const Table& split);

// View space and CVV over clip space on the first mix: times, operations, divisions.
std::string cost_finding(const Table& times, const Table& operations);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tables of the frontier. Each measure of error has a frontier of its own:
//
//   max_px      columns on_frontier, dominated_by
//   misrounded  on_rounding_frontier, rounding_dominated_by
//   wrong       on_wrong_frontier, wrong_dominated_by
//
// on_…: yes, no, or `not timed`. dominated_by: the fastest of the members that are not slower, not less
// accurate, and better in one of the two (experiments/measure/pareto.hpp).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/frontier/contest.hpp"
#include "experiments/report/table.hpp"

namespace clipscope::experiments {

// The keys of a measure's columns in the table `frontier`.
struct FrontierKeys {
  std::string_view error, on, dominated_by;
};
FrontierKeys frontier_keys(ErrorMeasure measure);

Table frontier_table();        // set, contract, clipper, scalar: time, errors, standing
Table frontier_steps_table();  // set, contract, measure: from one member to the next, and what that buys
Table frontier_refused_table();  // who was not timed, and why

// Entries of one contract.
void add_frontier_rows(const std::string& set, std::span<const Entry> entries, Table& table);
void add_step_rows(const std::string& set, std::span<const Entry> entries, Table& table);
void add_refused_rows(const std::string& set, std::span<const Entry> entries, Table& table);

// The sets in the table, in order. Pre-condition: rows of a set are together.
std::vector<std::string> sets_of(const Table& frontier);

// Set by set: how many are on the frontier by max_px in the full contract, where it begins and what its first
// steps cost; and in the stage what correct rounding costs.
// Computed from the rows. Pre-condition: `frontier` and `steps` have the rows of the same sets.
std::string frontier_finding(const Table& frontier, const Table& steps);

}  // namespace clipscope::experiments

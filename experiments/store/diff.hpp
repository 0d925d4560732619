// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two runs compared: which figures moved.
//
// Rows: a row's key is its cells in the fewest leading columns by which each row of either table
// can be told from the others; rows of the same key are compared. Where all columns are not enough,
// the key is the leading columns of text, and rows of the same key are compared in their order.
// Intervals: columns S_low and S_high that follow a column whose key begins with S, in this order,
// are the interval of that column's figure (ns_per_triangle, ns_low, ns_high). Such a figure has
// moved if the intervals of both runs have no point in common. A figure without an interval has
// moved if it is another value; NaN is the same as NaN, and 0 as -0.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/store/results_store.hpp"
#include "experiments/table/table.hpp"

namespace clipscope::experiments {

struct MovedFigure {
  std::string table;
  std::string row;     // its key: "teapot, textbook, float"
  std::string column;  // the key of the column
  Cell a, b;
};

struct LoneRow {  // in one run only
  std::string table;
  std::string row;  // empty: the whole table, or the column named
  std::string column;
  bool in_a;
};

struct RunDifference {  // of machine, options, ...
  std::string what, a, b;
};

struct Difference {
  std::vector<MovedFigure> moved;
  std::vector<LoneRow> lone;
  std::vector<RunDifference> runs;
  std::size_t figures = 0;  // that were compared
};

// Adds what differs between two tables of the same name.
void add_difference(const Table& a, const Table& b, Difference& difference);

// All tables, or the one that is named. Errors: UsageError if neither run has it; InputError.
Difference difference_of(const ResultsStore& a, const ResultsStore& b,
                         const std::optional<std::string>& table);

}  // namespace clipscope::experiments

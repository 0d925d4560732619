// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tables of the order of planes: empty ones with their columns and notes, and what fills them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "experiments/measure/timing.hpp"
#include "experiments/plane_order/measure.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/report/table.hpp"
#include "experiments/store/cell_record.hpp"

namespace clipscope::experiments {

// What was measured on one set.
struct SetResult {
  TriangleSet set;
  ExactOrders exact;
  RoundedOrders in_float, in_double;
};

// By set: does anything depend on the order?
Table orders_table();
void add_set(const SetResult& result, Table& table);
// The same with a last row "all". Pre-condition: at least one row.
Table with_all(const Table& by_set);

// By the place of the near plane in the order, and for the orders that clippers have.
Table classes_table();
void add_classes(const SetResult& result, Table& table);

// The triangles on which near last is farthest from near first.
void add_worst(const SetResult& result, CellRecord& record);

// The time of near last and others, against near first in the same rounds.
Table order_times_table();
void add_times(const std::string& mix, std::span<const AnyContestant> contestants,
               std::span<const Timing> timings, Table& table, CellRecord& record);

// By the place of the near plane: the share of wrong triangles in float; the vertices that are computed.
Plot wrong_plot(const Table& classes);
Plot intersections_plot(const Table& classes);

// The answer to the experiment's question, by the table with the row "all".
std::string orders_finding(const Table& orders, const Table& times);

}  // namespace clipscope::experiments

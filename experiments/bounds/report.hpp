// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of the bounding volumes, what is drawn of it, and the finding.
#pragma once

#include <optional>
#include <string>

#include "experiments/bounds/measure.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/report/table.hpp"
#include "experiments/store/cell_record.hpp"

namespace clipscope::experiments {

Table bounds_table();

// Adds a row, and the samples to the record.
void add_bound(const ObjectScene& scene, const Contestant<float>& clipper,
               const BoundResult& result, Table& table, CellRecord& record);

// Both for one clipper, the first of the table; nothing if it has no rows.
std::optional<Plot> settled_plot(const Table& table);  // share of objects settled, by scene
std::optional<Plot> speedup_plot(const Table& table);

std::string bounds_finding(const Table& table);

}  // namespace clipscope::experiments

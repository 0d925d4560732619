// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tables of the line clippers come to: two plots and the finding.
#pragma once

#include <optional>
#include <string>

#include "experiments/report/plot.hpp"
#include "experiments/report/table.hpp"

namespace clipscope::experiments {

// Time per segment by mix, in the scalar of the first row; nothing if nothing was timed.
std::optional<Plot> time_plot(const Table& times);

// Divisions that cut, per segment by mix; nothing for an empty table.
std::optional<Plot> divisions_plot(const Table& operations);

// Says what of it the tables hold.
std::string segments_finding(const Table& times, const Table& operations,
                             const Table& intersections);

}  // namespace clipscope::experiments

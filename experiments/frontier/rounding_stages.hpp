// SPDX-License-Identifier: GPL-3.0-or-later
//
// What settles the signs and quotients of the correctly rounded clipper: the filter in double, or expansions,
// and by which of their steps (barycentric::Stage).
#pragma once

#include <span>
#include <string>

#include "experiments/measure/timing.hpp"
#include "experiments/report/table.hpp"

namespace clipscope::experiments {

// set, input (view space, clip space): how many signs and quotients, and shares in percent.
Table rounding_stages_table();

// The triangles in view space, and brought to clip space by the float transform.
void add_rounding_stage_rows(const std::string& set, std::span<const TimedBatch> batches,
                             Table& table);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Times of float clippers as claims compare them.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "experiments/cost/rows.hpp"
#include "experiments/table/results.hpp"

namespace clipscope::experiments::claims {

// How many times faster than its table's baseline a clipper is on a mix in float. Throws
// MissingFigure where it was not timed.
template <class Row = cost::Row>
MedianInterval speed_of(const Results& results, const std::string& mix, std::string_view clipper) {
  const Row& row = results.row<Row>(&Row::mix, mix, &Row::clipper, clipper, &Row::scalar, "float");
  if (row.timing && row.timing->speedup) return *row.timing->speedup;
  throw MissingFigure(fmt::format("table {} has no time of {} on {}", Row::kName, clipper, mix));
}

}  // namespace clipscope::experiments::claims

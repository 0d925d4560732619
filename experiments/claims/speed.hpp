// SPDX-License-Identifier: GPL-3.0-or-later
//
// Speeds that claims compare, from the tables of times.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "experiments/cost/rows.hpp"
#include "experiments/table/results.hpp"

namespace clipscope::experiments::claims {

// A clipper's time on a mix in float, and how many times faster than the table's baseline it is.
struct Speed {
  double ns = 0;
  MedianInterval speedup;

  // Faster beyond the intervals of both.
  bool operator>(const Speed& other) const { return speedup.low > other.speedup.high; }
};

// Row: of a table that has a mix, a clipper, a scalar and a timing.
template <class Row = cost::Row>
Speed speed(const Results& results, const std::string& mix, std::string_view clipper) {
  const Row& row = results.row<Row>(&Row::mix, mix, &Row::clipper, clipper, &Row::scalar, "float");
  if (row.timing && row.timing->speedup) return {row.timing->ns.median, *row.timing->speedup};
  throw MissingFigure(fmt::format("table {} has no time of {} on {}", Row::kName, clipper, mix));
}

}  // namespace clipscope::experiments::claims

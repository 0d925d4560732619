// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/measure/accuracy_table.hpp"

#include <string>

namespace clipscope::experiments {

std::vector<Column> accuracy_columns() {
  std::vector<Column> columns = {{"clipper", "clipper"}, {"scalar", "scalar"}};
  for (const std::string_view name : kOutcomeNames) {
    columns.push_back({std::string(name), std::string(name)});
  }
  columns.insert(columns.end(), {{"median_px", "median px"},
                                 {"max_px", "max px"},
                                 {"median_ulp", "median ulp"},
                                 {"max_ulp", "max ulp"},
                                 {"median_attribute", "median attr"},
                                 {"max_attribute", "max attr"}});
  return columns;
}

std::vector<Cell> accuracy_cells(const AnyContestant& contestant, const AccuracyTally& tally) {
  std::vector<Cell> cells = {std::string(clipper_name(contestant)),
                             std::string(scalar_name(contestant))};
  for (const std::int64_t count : tally.outcomes) cells.emplace_back(count);
  for (const LogHistogram* errors : {&tally.position_px, &tally.position_ulp, &tally.attribute}) {
    if (errors->count() == 0) {
      cells.insert(cells.end(), 2, std::monostate());
    } else {
      cells.insert(cells.end(), {errors->quantile(0.5), errors->max()});
    }
  }
  return cells;
}

void add_accuracy_notes(Table& table) {
  table.add_note(
      "Outcomes count triangles that are visible in truth or in the answer. Errors are each "
      "triangle's "
      "largest, over triangles with the right vertices: px on 3840 x 2160; ulp of the scalar's own "
      "format over x, y, z and 1/w; attributes absolute.");
}

}  // namespace clipscope::experiments

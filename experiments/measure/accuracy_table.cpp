// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/measure/accuracy_table.hpp"

#include <string>

namespace clipscope::experiments {
namespace {

// Scenes are in view space, which every clipper takes.
constexpr int kTriangleOutcomes = static_cast<int>(Outcome::not_applicable);

}  // namespace

std::vector<Column> accuracy_columns() {
  std::vector<Column> columns = {{"clipper", "clipper"}, {"scalar", "scalar"}};
  for (int i = 0; i < kTriangleOutcomes; ++i) {
    const std::string name(kOutcomeNames[static_cast<std::size_t>(i)]);
    columns.push_back({name, name});
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
  for (int i = 0; i < kTriangleOutcomes; ++i) {
    cells.emplace_back(tally.outcomes[static_cast<std::size_t>(i)]);
  }
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

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The error budget of contestants on a scene: how large each part gets, over all its triangles.
//
// Triangles are split in parallel and tallied in order: the result does not depend on the threads.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "experiments/budget/stages.hpp"
#include "experiments/measure/statistics.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/report/progress.hpp"
#include "experiments/report/table.hpp"

namespace clipscope::experiments {

struct BudgetTally {
  struct Part {
    LogHistogram px, ulp;  // one value per triangle with a budget
  };
  std::array<Part, kBudgetParts.size()> parts;
  std::int64_t triangles = 0;  // with a budget
  std::int64_t left_out = 0;   // visible, but without one
  // The triangle with the largest total [px]: view and number in the mesh.
  std::size_t worst_view = 0, worst_triangle = 0;
};

// float and double, as far as they are selected: the others have no rounding to speak of. Only clippers
// that have a budget.
std::vector<AnyContestant> budget_contestants(std::string_view clipper_pattern,
                                              const std::vector<std::string>& scalars);

// One per contestant; advances progress by triangle and contestant. triangles_per_view: evenly spaced.
// Pre-condition: contestants of budget_contestants.
std::vector<BudgetTally> measure_budget(const Scene& scene,
                                        std::span<const AnyContestant> contestants,
                                        std::size_t triangles_per_view, Progress& progress);

Table budget_table();  // scene, clipper, scalar, part
void add_budget_rows(const std::string& scene, std::span<const AnyContestant> contestants,
                     std::span<const BudgetTally> tallies, Table& table);

// Parts by clipper on one scene in one scalar, one clipper of each space. Pre-condition: such rows.
Plot budget_plot(const Table& table, const std::string& scene, const std::string& scalar);

// The part that is largest most often, by clipper. From the rows.
std::string budget_finding(const Table& table);

}  // namespace clipscope::experiments

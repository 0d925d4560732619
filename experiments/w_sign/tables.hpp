// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tables, the plot and the finding of the experiment about the sign of w. What is said at the end is
// computed from rows of the tables alone.
#pragma once

#include <array>
#include <string>

#include "experiments/hard_cases/judge.hpp"
#include "experiments/measure/outcome.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/report/table.hpp"
#include "experiments/store/cell_record.hpp"
#include "experiments/w_sign/epsilon.hpp"
#include "experiments/w_sign/eye_picture.hpp"
#include "experiments/w_sign/patterns.hpp"

namespace clipscope::experiments {

using OutcomeCounts = std::array<std::int64_t, kOutcomes>;

Table w_sign_cases_table();
void add_w_sign_cases_row(Table& table, const CaseContestant& contestant,
                          const OutcomeCounts& counts);

Table w_sign_patterns_table();
// Records a triangle that the contestant fails on, too.
void add_w_sign_pattern_row(Table& table, CellRecord& record, const std::string& pattern,
                            const AnyContestant& contestant, const SweepTally& tally);

Table w_sign_epsilon_table();
void add_w_sign_epsilon_row(Table& table, const std::string& surface, const HardCase& hard_case,
                            double scale, const WPlaneClipper& clipper, const VisibleLoss& loss);

Table w_sign_prevented_table();
struct PreventedRow {
  std::string input;
  double scale = 1;
  bool depth_clamp = false;
  WPlaneClipper clipper;
  DivisionHazards without, with;  // without a w-plane; with the clipper's
  VisibleLossTally loss;
};
void add_w_sign_prevented_row(Table& table, const PreventedRow& row);

Table w_sign_pictures_table();
void add_w_sign_picture_row(Table& table, const EyePicture& picture);

// Visible area lost over the scale of the scene, one line for each epsilon that loses any.
Plot w_sign_loss_plot(const Table& epsilon);

std::string w_sign_finding(const Table& patterns, const Table& epsilon, const Table& prevented);

}  // namespace clipscope::experiments

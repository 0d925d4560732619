// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tables of the stage contract, and what is made from their rows: plots and the finding.
#pragma once

#include <span>
#include <string>

#include "experiments/cost/growth.hpp"
#include "experiments/measure/stage_timing.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/report/table.hpp"

namespace clipscope::experiments {

Table cost_stage_table();        // mix, clipper, scalar, build, contract: time, ratio, bytes, limit
Table cost_stage_mixes_table();  // mix: triangles and their shares
Table cost_stage_refused_table();  // who was not timed, and why
Table cost_growth_table();         // what grows, by how much, clipper and so on: time

void add_stage_rows(const std::string& mix, const StageMeasurement& measured, Table& table);
void add_mix_row(const StageInput& input, StageContract contract, Table& table);
void add_stage_refused_rows(const std::string& mix, const StageMeasurement& measured, Table& table);
void add_growth_rows(std::span<const GrowthPoint> points, Table& table);

// Times faster than textbook by mix, one bar per clipper of the best build in the contract.
Plot stage_plot(const Table& stage, StageContract contract);
// ns per triangle over what grows.
Plot growth_plot(const Table& growth, Growing growing);

// The fastest of each contract and mix against textbook, and the price of correct rounding.
std::string stage_finding(const Table& stage);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tables of the hard cases: empty ones with their columns and notes, and what fills them.
#pragma once

#include <string>
#include <vector>

#include "experiments/catalogue/ulp_grid.hpp"
#include "experiments/hard_cases/verdicts.hpp"
#include "experiments/report/table.hpp"

namespace clipscope::experiments {

// One row per case, in it one verdict per contestant.
using Verdicts = std::vector<std::vector<CaseVerdict>>;

// The verdict matrix of one primitive: a row per case, a column per scalar, a letter per clipper.
Table matrix_table(const CaseSet& set, const std::vector<std::string>& scalars);
void add_matrix(const CaseSet& set, const Verdicts& verdicts,
                const std::vector<std::string>& scalars, Table& table);

// Every verdict on its own, for those who want to compute with them.
Table verdicts_table();
void add_verdicts(const CaseSet& set, const Verdicts& verdicts, Table& table);

// How many cases each contestant fails on, and which promises it breaks.
Table summary_table();
void add_summary(const CaseSet& set, const Verdicts& verdicts, Table& table);

Table families_table();
void add_families(const CaseSet& set, const std::vector<FamilyTally>& tallies, Table& table);

Table policy_table();
void add_policy(const CaseSet& set, const std::vector<PolicyTally>& tallies, Table& table);

// Which of the catalogue's cases notice each of the seeded bugs.
Table mutants_table();
void add_mutants(const std::vector<HardCase>& catalogue, Table& table);

// How plane predicates sign a grid of neighbouring floats.
Table signs_table();
void add_signs(const UlpGrid& grid, Table& table);

}  // namespace clipscope::experiments

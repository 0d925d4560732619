// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hard cases: catalogue x clippers x scalars, the families around the cases, NaN and infinity, an
// exhaustive lattice, ulp grids, and whether the catalogue would notice a bug.
#include <fmt/format.h>

#include <algorithm>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/hard_cases/case_picture.hpp"
#include "experiments/hard_cases/rows.hpp"
#include "experiments/hard_cases/ulp_picture.hpp"
#include "experiments/render/figure.hpp"
#include "experiments/report/experiment.hpp"
#include "experiments/survey/lattice_sweep.hpp"

namespace clipscope::experiments::hard_cases {
namespace {

constexpr std::array kPrimitives = {Primitive::triangle, Primitive::segment, Primitive::point,
                                    Primitive::polygon};

// Exact arithmetic and double-double are judged on the cases themselves, the binary formats on
// their families, too: that is where errors are.
std::vector<std::string> binary_formats(std::vector<std::string> scalars) {
  std::erase_if(scalars, [](const std::string& s) {
    return s != kFormat<float>.name && s != kFormat<double>.name;
  });
  return scalars;
}

CaseSet case_set(Primitive primitive, const Selection& selection,
                 const std::vector<std::string>& scalars) {
  CaseSet set{primitive, {}, case_contestants(primitive, selection, scalars)};
  for (const HardCase& c : builtin_catalogue()) {
    if (c.primitive == primitive) set.cases.push_back(&c);
  }
  return set;
}

// One file for each case, clipper and scalar that fails: cases/THEME_NAME_CLIPPER_SCALAR.svg
void draw_failures(const ExperimentContext& context, const CaseSet& set, const Verdicts& verdicts,
                   PieceRecord& record) {
  for (std::size_t i = 0; i < set.cases.size(); ++i) {
    for (std::size_t c = 0; c < set.contestants.size(); ++c) {
      if (!is_failure(verdicts[i][c].comparison.outcome)) continue;
      const HardCase& hard_case = *set.cases[i];
      const Contestant& contestant = *set.contestants[c];
      std::string file =
          fmt::format("{}_{}_{}.svg", hard_case.name, contestant.clipper, contestant.scalar());
      std::ranges::replace(file, '/', '_');
      file.insert(0, "cases/");
      write_case_picture(context.out() / file, picture_of(hard_case, contestant));
      record.pictures.push_back({file, fmt::format("{}: {} in {}", hard_case.name,
                                                   contestant.clipper, contestant.scalar())});
    }
  }
}

void judge_catalogue(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  TableOf<VerdictRow> all;
  TableOf<SummaryRow> summary;
  for (const Primitive primitive : kPrimitives) {
    const CaseSet set = case_set(primitive, selection, selection.scalars);
    if (set.contestants.empty()) continue;
    Table matrix = matrix_table(set, selection.scalars);
    const std::string name = fmt::format("verdicts on {}s", name_of(primitive));
    context.piece(name, {&matrix, &all, &summary}, [&](PieceRecord& record) {
      Progress progress(fmt::format("hard {}s", name_of(primitive)), set.cases.size());
      const Verdicts verdicts = judge_cases(set, progress);
      add_matrix(set, verdicts, selection.scalars, matrix);
      add_rows(set, verdicts, all);
      add_rows(set, verdicts, summary);
      if (selection.pictures) draw_failures(context, set, verdicts, record);
    });
    context.emit(matrix);
  }
  if (selection.pictures) context.emit_file(context.out() / "cases" / "*.svg");
  context.emit(all, summary);
  context.finding(finding(summary.rows()));
}

void try_mutants(const ExperimentContext& context) {
  TableOf<MutantRow> table;
  context.piece("mutants", {&table}, [&](PieceRecord&) {
    for (const MutantRow& row : mutant_rows(builtin_catalogue())) table.add(row);
  });
  context.emit(table);
}

void show_signs(const ExperimentContext& context) {
  std::vector<UlpGrid> grids;
  for (const PlaneGrid& grid : plane_grids()) grids.push_back(grid.grid);
  grids.push_back(edge_grid().grid);
  TableOf<SignRow> table;
  for (const UlpGrid& grid : grids) {
    const std::string file = fmt::format("signs_{}.png", grid.name);
    context.piece(fmt::format("signs {}", grid.name), {&table}, [&](PieceRecord& record) {
      add_rows(grid, table);
      write_png(context.out() / file, ulp_picture(grid), grid.title);
      record.pictures.push_back({file, "Signs of plane predicates: " + grid.title});
    });
    context.emit_file(context.out() / file);
  }
  context.emit(table);
}

void judge_all_families(const ExperimentContext& context, const std::vector<std::string>& scalars) {
  TableOf<FamilyRow> families;
  TableOf<PolicyRow> policy;
  for (const Primitive primitive : kPrimitives) {
    CaseSet set = case_set(primitive, context.selection(), scalars);
    if (set.contestants.empty()) continue;
    // The tests judge the families of all cases.
    const std::size_t part = context.selection().quick ? 16 : 3;
    set.cases = evenly_spaced(set.cases, set.cases.size() / part + 1);
    const std::string name = fmt::format("families of {}s", name_of(primitive));
    context.piece(name, {&families, &policy}, [&](PieceRecord&) {
      Progress progress(name, 2 * set.cases.size());
      add_rows(set, judge_families(set, progress), families);
      add_rows(set, judge_special_values(set, progress), policy);
    });
  }
  context.emit(families, policy);
}

void run(const ExperimentContext& context) {
  judge_catalogue(context);
  try_mutants(context);
  show_signs(context);
  const std::vector<std::string> scalars = binary_formats(context.selection().scalars);
  if (scalars.empty()) return;
  judge_all_families(context, scalars);
  const SweepPlan plan = lattice_plan("small", context.selection());
  TableOf<SweepRow> lattice = plan.table();
  context.piece("lattice small", {&lattice},
                [&](PieceRecord&) { lattice = sweep(plan, context.selection()); });
  context.emit(lattice);
}

}  // namespace

extern constinit const Experiment kExperiment{
    "hard_cases", "Which clipper gets which hard case wrong, and how?", run};

}  // namespace clipscope::experiments::hard_cases

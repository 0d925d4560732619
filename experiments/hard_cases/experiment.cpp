// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hard cases: catalogue x clippers x scalars, the families around the cases, NaN and infinity, an
// exhaustive lattice, ulp grids, and whether the catalogue would notice a bug.
#include <fmt/format.h>

#include <algorithm>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/catalogue/ulp_picture.hpp"
#include "experiments/experiment.hpp"
#include "experiments/hard_cases/case_picture.hpp"
#include "experiments/hard_cases/lattice_sweep.hpp"
#include "experiments/hard_cases/tables.hpp"
#include "experiments/render/figure.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::array kPrimitives = {Primitive::triangle, Primitive::segment, Primitive::point,
                                    Primitive::polygon};

// Exact arithmetic and double-double are judged on the cases themselves, the binary formats on their
// families, too: that is where errors are.
std::vector<std::string> binary_formats(const std::vector<std::string>& scalars) {
  std::vector<std::string> r;
  for (const std::string& s : scalars) {
    if (s == ScalarTraits<float>::name || s == ScalarTraits<double>::name) r.push_back(s);
  }
  return r;
}

CaseSet case_set(const std::vector<HardCase>& catalogue, Primitive primitive,
                 const Selection& selection, const std::vector<std::string>& scalars) {
  CaseSet set{primitive, {}, case_contestants(primitive, selection.clipper, scalars)};
  for (const HardCase& c : catalogue) {
    if (c.primitive == primitive) set.cases.push_back(&c);
  }
  return set;
}

// One file for each case, clipper and scalar that fails: cases/THEME_NAME_CLIPPER_SCALAR.svg
void draw_failures(const ExperimentContext& context, const CaseSet& set, const Verdicts& verdicts) {
  const std::filesystem::path folder = context.out() / "cases";
  std::error_code ignored;  // what cannot be made cannot be written to: that says so
  std::filesystem::create_directories(folder, ignored);
  std::int64_t drawn = 0;
  for (std::size_t i = 0; i < set.cases.size(); ++i) {
    const HardCase& hard_case = *set.cases[i];
    const TruthPolygon truth = truth_polygon(hard_case);
    for (std::size_t c = 0; c < set.contestants.size(); ++c) {
      if (!is_failure(verdicts[i][c].comparison.outcome)) continue;
      const CaseContestant& contestant = set.contestants[c];
      std::string name =
          fmt::format("{}_{}_{}.svg", hard_case.name, contestant.clipper, contestant.scalar);
      std::replace(name.begin(), name.end(), '/', '_');
      const CaseAnswer answer = contestant.answer(hard_case, truth);
      write_case_picture(folder / name,
                         {hard_case, truth, answer, contestant.clipper, contestant.scalar});
      ++drawn;
    }
  }
  context.emit_file(folder / fmt::format("({} pictures of {}s)", drawn, to_string(set.primitive)));
}

void judge_catalogue(const ExperimentContext& context, const std::vector<HardCase>& catalogue) {
  const Selection& selection = context.selection();
  Table all = verdicts_table();
  Table summary = summary_table();
  for (const Primitive primitive : kPrimitives) {
    const CaseSet set = case_set(catalogue, primitive, selection, selection.scalars);
    if (set.contestants.empty()) continue;
    Progress progress(fmt::format("hard {}s", to_string(primitive)), set.cases.size());
    const Verdicts verdicts = judge_cases(set, progress);
    context.emit(matrix_table(set, verdicts, selection.scalars));
    if (selection.pictures) draw_failures(context, set, verdicts);
    add_verdicts(set, verdicts, all);
    add_summary(set, verdicts, summary);
  }
  all.write(context.out());
  context.emit(summary);
  context.emit_file(context.out() / "hard_cases_verdicts.{md,csv,tex}");
}

void judge_all_families(const ExperimentContext& context, const std::vector<HardCase>& catalogue) {
  const Selection& selection = context.selection();
  Table families = families_table();
  Table policy = policy_table();
  for (const Primitive primitive : kPrimitives) {
    const CaseSet set =
        case_set(catalogue, primitive, selection, binary_formats(selection.scalars));
    if (set.contestants.empty()) continue;
    Progress progress(fmt::format("families of {}s", to_string(primitive)), 2 * set.cases.size());
    add_families(set, judge_families(set, progress), families);
    add_policy(set, judge_special_values(set, progress), policy);
  }
  context.emit(families);
  context.emit(policy);
}

void show_grid(const ExperimentContext& context, const UlpGrid& grid, Table& table) {
  const SignMap exact = sign_map(grid, grid.exact);
  for (const Predicate& predicate : grid.predicates) {
    const SignCounts counts = compare(sign_map(grid, predicate.sign_of), exact);
    table.add_row({grid.title, predicate.title, counts.right, counts.opposite, counts.false_zero,
                   counts.missed_zero});
  }
  const std::filesystem::path path = context.out() / fmt::format("signs_{}.png", grid.name);
  write_png(path, ulp_picture(grid), grid.title);
  context.emit_file(path);
}

void show_signs(const ExperimentContext& context) {
  Table table(
      "hard_cases_signs",
      "Signs of plane predicates on 256 x 256 neighbouring floats around a point of a plane",
      {{"grid", "grid"},
       {"predicate", "predicate"},
       {"right", "right"},
       {"opposite", "opposite"},
       {"false_zero", "false zero"},
       {"missed_zero", "missed zero"}});
  for (const PlaneGrid& grid : plane_grids()) show_grid(context, grid.grid, table);
  show_grid(context, edge_grid().grid, table);
  context.emit(table);
}

}  // namespace

void run_hard_cases(const ExperimentContext& context) {
  const std::vector<HardCase>& catalogue = builtin_catalogue();
  judge_catalogue(context, catalogue);
  context.emit(mutants_table(catalogue));
  show_signs(context);
  if (binary_formats(context.selection().scalars).empty()) return;
  judge_all_families(context, catalogue);
  context.emit(sweep_lattice("small", context.selection()));
}

}  // namespace clipscope::experiments

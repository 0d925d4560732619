// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hard cases: catalogue x clippers x scalars, the families around the cases, NaN and infinity, an
// exhaustive lattice, ulp grids, and whether the catalogue would notice a bug.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/catalogue/ulp_picture.hpp"
#include "experiments/experiment.hpp"
#include "experiments/hard_cases/case_picture.hpp"
#include "experiments/hard_cases/lattice_sweep.hpp"
#include "experiments/hard_cases/tables.hpp"
#include "experiments/render/figure.hpp"
#include "experiments/report/row_view.hpp"

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
void draw_failures(const ExperimentContext& context, const CaseSet& set, const Verdicts& verdicts,
                   CellRecord& record) {
  const std::filesystem::path folder = context.out() / "cases";
  std::error_code ignored;  // what cannot be made cannot be written to: that says so
  std::filesystem::create_directories(folder, ignored);
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
      record.pictures.push_back(
          {"cases/" + name,
           fmt::format("{}: {} in {}", hard_case.name, contestant.clipper, contestant.scalar)});
    }
  }
}

std::int64_t failures_in_float(const Table& summary, const std::string& clipper) {
  for (const RowView& row : rows_of(summary)) {
    if (row.text("primitive") == "triangle" && row.text("clipper") == clipper &&
        row.text("scalar") == "float") {
      return row.count("failures");
    }
  }
  return -1;
}

// How often the usual clipper of each space fails on triangles in float.
std::string finding_of(const Table& summary) {
  std::vector<std::string> parts;
  for (const auto& [space, clipper] :
       {std::pair{"view space", "view/sutherland_hodgman"},
        std::pair{"clip space", "homogeneous/sutherland_hodgman"},
        std::pair{"the CVV (near plane first)", "cvv/near_first"},
        std::pair{"the CVV (divide first)", "cvv/naive"},
        std::pair{"the distance matrix", "barycentric/distance_matrix"}}) {
    const std::int64_t failures = failures_in_float(summary, clipper);
    if (failures >= 0) parts.push_back(fmt::format("{} {}", space, failures));
  }
  return fmt::format("Triangles of the catalogue that float clipping gets wrong: {}.",
                     fmt::join(parts, ", "));
}

void judge_catalogue(const ExperimentContext& context, const std::vector<HardCase>& catalogue) {
  const Selection& selection = context.selection();
  Table all = verdicts_table();
  Table summary = summary_table();
  for (const Primitive primitive : kPrimitives) {
    const CaseSet set = case_set(catalogue, primitive, selection, selection.scalars);
    if (set.contestants.empty()) continue;
    Table matrix = matrix_table(set, selection.scalars);
    const auto judge = [&](CellRecord& record) {
      Progress progress(fmt::format("hard {}s", to_string(primitive)), set.cases.size());
      const Verdicts verdicts = judge_cases(set, progress);
      add_matrix(set, verdicts, selection.scalars, matrix);
      add_verdicts(set, verdicts, all);
      add_summary(set, verdicts, summary);
      if (selection.pictures) draw_failures(context, set, verdicts, record);
    };
    context.cell(fmt::format("verdicts on {}s", to_string(primitive)), {&matrix, &all, &summary},
                 judge);
    context.emit(matrix);
  }
  if (selection.pictures) context.emit_file(context.out() / "cases" / "*.svg");
  context.emit(all);
  context.emit(summary);
  context.finding(finding_of(summary));
}

void judge_all_families(const ExperimentContext& context, const std::vector<HardCase>& catalogue) {
  const Selection& selection = context.selection();
  Table families = families_table();
  Table policy = policy_table();
  for (const Primitive primitive : kPrimitives) {
    const CaseSet set =
        case_set(catalogue, primitive, selection, binary_formats(selection.scalars));
    if (set.contestants.empty()) continue;
    const std::string name = fmt::format("families of {}s", to_string(primitive));
    context.cell(name, {&families, &policy}, [&](CellRecord&) {
      Progress progress(name, 2 * set.cases.size());
      add_families(set, judge_families(set, progress), families);
      add_policy(set, judge_special_values(set, progress), policy);
    });
  }
  context.emit(families);
  context.emit(policy);
}

void show_signs(const ExperimentContext& context) {
  std::vector<UlpGrid> grids;
  for (const PlaneGrid& grid : plane_grids()) grids.push_back(grid.grid);
  grids.push_back(edge_grid().grid);
  Table table = signs_table();
  for (const UlpGrid& grid : grids) {
    const std::string file = fmt::format("signs_{}.png", grid.name);
    context.cell(fmt::format("signs {}", grid.name), {&table}, [&](CellRecord& record) {
      add_signs(grid, table);
      write_png(context.out() / file, ulp_picture(grid), grid.title);
      record.pictures.push_back({file, "Signs of plane predicates: " + grid.title});
    });
    context.emit_file(context.out() / file);
  }
  context.emit(table);
}

void try_mutants(const ExperimentContext& context, const std::vector<HardCase>& catalogue) {
  Table table = mutants_table();
  context.cell("mutants", {&table}, [&](CellRecord&) { add_mutants(catalogue, table); });
  context.emit(table);
}

void sweep_small_lattice(const ExperimentContext& context) {
  Table table = lattice_table("small", context.selection());
  context.cell("lattice small", {&table},
               [&](CellRecord&) { add_lattice("small", context.selection(), table); });
  context.emit(table);
}

}  // namespace

void run_hard_cases(const ExperimentContext& context) {
  const std::vector<HardCase>& catalogue = builtin_catalogue();
  judge_catalogue(context, catalogue);
  try_mutants(context, catalogue);
  show_signs(context);
  if (binary_formats(context.selection().scalars).empty()) return;
  judge_all_families(context, catalogue);
  sweep_small_lattice(context);
}

}  // namespace clipscope::experiments

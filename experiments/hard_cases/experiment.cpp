// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hard cases: catalogue x clippers x scalars, the families around the cases, NaN and infinity, an
// exhaustive lattice, ulp grids, and whether the catalogue would notice a bug.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/catalogue/lattice.hpp"
#include "experiments/catalogue/mutation_table.hpp"
#include "experiments/catalogue/ulp_picture.hpp"
#include "experiments/experiment.hpp"
#include "experiments/hard_cases/case_picture.hpp"
#include "experiments/hard_cases/lattice_sweep.hpp"
#include "experiments/hard_cases/verdicts.hpp"
#include "experiments/render/figure.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::array kPrimitives = {Primitive::triangle, Primitive::segment, Primitive::point,
                                    Primitive::polygon};

// The outcomes of a row of the matrix, one letter per clipper.
constexpr std::string_view kLetters = "=~.v#MXFN-";
constexpr std::string_view kLegend =
    "= exact  ~ faithful (1 ulp)  . subpixel (< 1/256 px)  v visible  # another number of vertices "
    " "
    "M missing  X extra  F flipped  N not finite  - not applicable";

char letter(Outcome outcome) { return kLetters[static_cast<std::size_t>(outcome)]; }

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

using Verdicts = std::vector<std::vector<CaseVerdict>>;

// Clippers in the order of their letters, without repetition.
std::vector<std::string> clippers_of(const CaseSet& set) {
  std::vector<std::string> names;
  for (const CaseContestant& c : set.contestants) {
    if (names.empty() || names.back() != c.clipper) names.push_back(c.clipper);
  }
  return names;
}

Table matrix_table(const CaseSet& set, const Verdicts& verdicts,
                   const std::vector<std::string>& scalars) {
  const std::string primitive = to_string(set.primitive);
  std::vector<Column> columns = {{"case", "case"}, {"expected", "exact"}};
  for (const std::string& scalar : scalars) columns.push_back({scalar, scalar});
  Table table(fmt::format("hard_cases_{}s", primitive),
              fmt::format("Verdicts on {}s, one letter per clipper", primitive), columns);
  for (std::size_t i = 0; i < set.cases.size(); ++i) {
    std::map<std::string, std::string> letters;
    for (const std::string& clipper : clippers_of(set)) {
      for (const std::string& scalar : scalars) {
        char l = ' ';  // there is no such contestant
        for (std::size_t c = 0; c < set.contestants.size(); ++c) {
          const CaseContestant& contestant = set.contestants[c];
          if (contestant.clipper == clipper && contestant.scalar == scalar) {
            l = letter(verdicts[i][c].comparison.outcome);
          }
        }
        letters[scalar] += l;
      }
    }
    std::vector<Cell> cells = {set.cases[i]->name, to_string(set.cases[i]->expected)};
    for (const std::string& scalar : scalars) cells.emplace_back(letters[scalar]);
    table.add_row(std::move(cells));
  }
  table.add_note(std::string(kLegend));
  table.add_note(fmt::format("Letters in the order of: {}.", fmt::join(clippers_of(set), ", ")));
  return table;
}

// Every verdict on its own, for those who want to compute with them.
void add_verdicts(const CaseSet& set, const Verdicts& verdicts, Table& table) {
  for (std::size_t i = 0; i < set.cases.size(); ++i) {
    for (std::size_t c = 0; c < set.contestants.size(); ++c) {
      const CaseVerdict& v = verdicts[i][c];
      std::vector<Cell> cells = {set.cases[i]->name, set.contestants[c].clipper,
                                 set.contestants[c].scalar,
                                 std::string(outcome_name(v.comparison.outcome))};
      if (v.comparison.outcome <= Outcome::visible) {
        cells.insert(cells.end(),
                     {v.comparison.position_px, v.comparison.position_ulp, v.comparison.attribute});
      } else {
        cells.insert(cells.end(), 3, std::monostate());
      }
      cells.emplace_back(v.promise.verdict == PromiseVerdict::broken ? v.promise.reason : "");
      table.add_row(std::move(cells));
    }
  }
}

void add_summary(const CaseSet& set, const Verdicts& verdicts, Table& table) {
  constexpr std::size_t kNamed = 3;
  for (std::size_t c = 0; c < set.contestants.size(); ++c) {
    std::int64_t applicable = 0, broken = 0;
    std::vector<std::string> failed;
    for (std::size_t i = 0; i < set.cases.size(); ++i) {
      const CaseVerdict& v = verdicts[i][c];
      if (v.comparison.outcome == Outcome::not_applicable) continue;
      ++applicable;
      broken += v.promise.verdict == PromiseVerdict::broken;
      if (is_failure(v.comparison.outcome)) failed.push_back(set.cases[i]->name);
    }
    const auto failures = static_cast<std::int64_t>(failed.size());
    if (failed.size() > kNamed) failed.resize(kNamed);
    std::string names = fmt::format("{}", fmt::join(failed, ", "));
    if (failures > static_cast<std::int64_t>(kNamed)) names += ", ...";
    table.add_row({to_string(set.primitive), set.contestants[c].clipper, set.contestants[c].scalar,
                   applicable, failures, broken, names});
  }
}

void add_families(const CaseSet& set, const std::vector<FamilyTally>& tallies, Table& table) {
  for (std::size_t c = 0; c < tallies.size(); ++c) {
    const FamilyTally& t = tallies[c];
    table.add_row({to_string(set.primitive), set.contestants[c].clipper, set.contestants[c].scalar,
                   t.variants, t.failures, t.broken,
                   set.primitive == Primitive::triangle ? Cell(t.largest_ulps) : Cell(), t.worst,
                   t.offender});
  }
}

void add_policy(const CaseSet& set, const std::vector<PolicyTally>& tallies, Table& table) {
  for (std::size_t c = 0; c < tallies.size(); ++c) {
    const PolicyTally& t = tallies[c];
    table.add_row({to_string(set.primitive), set.contestants[c].clipper, set.contestants[c].scalar,
                   t.inputs, t.drawn, t.offender});
  }
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
  Table all("hard_cases_verdicts", "Every verdict of the catalogue",
            {{"case", "case"},
             {"clipper", "clipper"},
             {"scalar", "scalar"},
             {"outcome", "outcome"},
             {"error_px", "error [px]"},
             {"error_ulp", "error [ulp]"},
             {"attribute_error", "attribute error"},
             {"broken_promise", "broken promise"}});
  Table summary("hard_cases", "The catalogue of hard cases, by clipper",
                {{"primitive", "primitive"},
                 {"clipper", "clipper"},
                 {"scalar", "scalar"},
                 {"cases", "cases"},
                 {"failures", "fails"},
                 {"promises_broken", "broken promises"},
                 {"failing", "fails on"}});
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
  summary.add_note(
      "Fails: the answer is not finite, has other vertices than the exact one, or is off by 1/256 "
      "px "
      "or more. Cases that a method does not take are not counted. Promises: see `clipscope list "
      "clippers`.");
  all.write(context.out());
  context.emit(summary);
  context.emit_file(context.out() / "hard_cases_verdicts.{md,csv,tex}");
}

void judge_all_families(const ExperimentContext& context, const std::vector<HardCase>& catalogue) {
  const Selection& selection = context.selection();
  Table families("hard_cases_families",
                 "Families around the hard cases: 2^k scalings, rotations, mirrored axes, depth "
                 "ranges, ulp neighbours, extreme values",
                 {{"primitive", "primitive"},
                  {"clipper", "clipper"},
                  {"scalar", "scalar"},
                  {"variants", "variants"},
                  {"failures", "fails"},
                  {"promises_broken", "broken"},
                  {"largest_backward_error", "largest error"},
                  {"worst", "on"},
                  {"offender", "first broken promise"}});
  Table policy("hard_cases_policy", "NaN and infinity in positions: nothing may come out",
               {{"primitive", "primitive"},
                {"clipper", "clipper"},
                {"scalar", "scalar"},
                {"inputs", "inputs"},
                {"drawn", "drawn"},
                {"offender", "first on"}});
  for (const Primitive primitive : kPrimitives) {
    const CaseSet set =
        case_set(catalogue, primitive, selection, binary_formats(selection.scalars));
    if (set.contestants.empty()) continue;
    Progress progress(fmt::format("families of {}s", to_string(primitive)), 2 * set.cases.size());
    add_families(set, judge_families(set, progress), families);
    add_policy(set, judge_special_values(set, progress), policy);
  }
  families.add_note(
      "Largest error: backward error in units of the promise, u M (see spaces/clipper.hpp), where "
      "the promise speaks of the variant.");
  context.emit(families);
  context.emit(policy);
}

void show_mutants(const ExperimentContext& context, const std::vector<HardCase>& catalogue) {
  Table table("hard_cases_mutants", "Seeded bugs, and how many cases notice them",
              {{"bug", "bug"}, {"caught_by", "caught by"}, {"sharpest", "sharpest case"}});
  for (const MutationRow& row : mutation_table(catalogue)) {
    table.add_row(
        {std::string(row.summary), static_cast<std::int64_t>(row.caught_by.size()), row.sharpest});
  }
  context.emit(table);
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
  show_mutants(context, catalogue);
  show_signs(context);
  if (binary_formats(context.selection().scalars).empty()) return;
  judge_all_families(context, catalogue);
  context.emit(sweep_lattice("small", context.selection()));
}

}  // namespace clipscope::experiments

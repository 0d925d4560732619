// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hard_cases/tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "experiments/catalogue/mutation_table.hpp"

namespace clipscope::experiments {
namespace {

// The outcomes of a row of the matrix, one letter per clipper.
constexpr std::string_view kLetters = "=~.v#MXFN-";
constexpr std::string_view kLegend =
    "= exact, ~ faithful (1 ulp), . subpixel (< 1/256 px), v visible, # another number of "
    "vertices, M "
    "missing, X extra, F flipped, N not finite, - not applicable, blank: not in this scalar.";

char letter(Outcome outcome) { return kLetters[static_cast<std::size_t>(outcome)]; }

// Clippers in the order of their letters, without repetition.
std::vector<std::string> clippers_of(const CaseSet& set) {
  std::vector<std::string> names;
  for (const CaseContestant& c : set.contestants) {
    if (names.empty() || names.back() != c.clipper) names.push_back(c.clipper);
  }
  return names;
}

}  // namespace

Table matrix_table(const CaseSet& set, const std::vector<std::string>& scalars) {
  const std::string primitive = to_string(set.primitive);
  std::vector<Column> columns = {{"case", "case"}, {"expected", "exact"}};
  for (const std::string& scalar : scalars) columns.push_back({scalar, scalar});
  Table table(fmt::format("hard_cases_{}s", primitive),
              fmt::format("Verdicts on {}s, one letter per clipper", primitive), columns);
  table.add_note(std::string(kLegend));
  table.add_note(fmt::format("Letters in the order of: {}.", fmt::join(clippers_of(set), ", ")));
  return table;
}

void add_matrix(const CaseSet& set, const Verdicts& verdicts,
                const std::vector<std::string>& scalars, Table& table) {
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
}

Table verdicts_table() {
  return Table("hard_cases_verdicts", "Every verdict of the catalogue",
               {{"case", "case"},
                {"clipper", "clipper"},
                {"scalar", "scalar"},
                {"outcome", "outcome"},
                {"error_px", "error [px]"},
                {"error_ulp", "error [ulp]"},
                {"attribute_error", "attribute error"},
                {"broken_promise", "broken promise"}});
}

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

Table summary_table() {
  Table table("hard_cases", "The catalogue of hard cases, by clipper",
              {{"primitive", "primitive"},
               {"clipper", "clipper"},
               {"scalar", "scalar"},
               {"cases", "cases"},
               {"failures", "fails"},
               {"promises_broken", "broken promises"},
               {"failing", "fails on"}});
  table.add_note(
      "Fails: the answer is not finite, has other vertices than the exact one, or is off by 1/256 "
      "px "
      "or more. Cases that a method does not take are not counted. Promises: see `clipscope list "
      "clippers`.");
  return table;
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

Table families_table() {
  Table table("hard_cases_families",
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
  table.add_note(
      "Largest error: backward error in units of the promise, u M (see spaces/clipper.hpp), where "
      "the promise speaks of the variant.");
  return table;
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

Table policy_table() {
  return Table("hard_cases_policy", "NaN and infinity in positions: nothing may come out",
               {{"primitive", "primitive"},
                {"clipper", "clipper"},
                {"scalar", "scalar"},
                {"inputs", "inputs"},
                {"drawn", "drawn"},
                {"offender", "first on"}});
}

void add_policy(const CaseSet& set, const std::vector<PolicyTally>& tallies, Table& table) {
  for (std::size_t c = 0; c < tallies.size(); ++c) {
    const PolicyTally& t = tallies[c];
    table.add_row({to_string(set.primitive), set.contestants[c].clipper, set.contestants[c].scalar,
                   t.inputs, t.drawn, t.offender});
  }
}

Table mutants_table() {
  return Table("hard_cases_mutants", "Seeded bugs, and how many cases notice them",
               {{"bug", "bug"}, {"caught_by", "caught by"}, {"sharpest", "sharpest case"}});
}

void add_mutants(const std::vector<HardCase>& catalogue, Table& table) {
  for (const MutationRow& row : mutation_table(catalogue)) {
    table.add_row(
        {std::string(row.summary), static_cast<std::int64_t>(row.caught_by.size()), row.sharpest});
  }
}

Table signs_table() {
  return Table(
      "hard_cases_signs",
      "Signs of plane predicates on 256 x 256 neighbouring floats around a point of a plane",
      {{"grid", "grid"},
       {"predicate", "predicate"},
       {"right", "right"},
       {"opposite", "opposite"},
       {"false_zero", "false zero"},
       {"missed_zero", "missed zero"}});
}

void add_signs(const UlpGrid& grid, Table& table) {
  const SignMap exact = sign_map(grid, grid.exact);
  for (const Predicate& predicate : grid.predicates) {
    const SignCounts counts = compare(sign_map(grid, predicate.sign_of), exact);
    table.add_row({grid.title, predicate.title, counts.right, counts.opposite, counts.false_zero,
                   counts.missed_zero});
  }
}

}  // namespace clipscope::experiments

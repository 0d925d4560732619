// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the hard cases' tables, and what fills them.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/catalogue/ulp_grid.hpp"
#include "experiments/contestants/columns.hpp"
#include "experiments/survey/verdicts.hpp"
#include "experiments/table/row.hpp"
#include "reference/mutants.hpp"

namespace clipscope::experiments::hard_cases {

// One row per case, in it one verdict per contestant.
using Verdicts = std::vector<std::vector<CaseVerdict>>;

// The verdict matrix of one primitive: a row per case, a column per scalar, a letter per clipper.
Table matrix_table(const CaseSet& set, const std::vector<std::string>& scalars);
void add_matrix(const CaseSet& set, const Verdicts& verdicts,
                const std::vector<std::string>& scalars, Table& table);

// Every verdict on its own, for those who want to compute with them.
struct VerdictRow {
  std::string hard_case, clipper, scalar;
  Outcome outcome = Outcome::exact;
  std::optional<Comparison> errors;  // where the vertices are the right ones
  std::string broken_promise;        // how; empty if it is kept

  static constexpr std::string_view kName = "hard_cases_verdicts";
  static constexpr std::string_view kTitle = "Every verdict of the catalogue";
  static constexpr auto columns() {
    using R = VerdictRow;
    using C = Comparison;
    return std::tuple(
        column("case", &R::hard_case), contestant_columns(&R::clipper, &R::scalar),
        column("outcome", &R::outcome),
        group(&R::errors, std::tuple(column("error_px", "error [px]", &C::position_px),
                                     column("error_ulp", "error [ulp]", &C::position_ulp),
                                     column("attribute_error", "attribute error", &C::attribute))),
        column("broken_promise", "broken promise", &R::broken_promise));
  }
};

// How many cases a contestant fails on, and how many promises it breaks.
struct SummaryRow {
  Primitive primitive = Primitive::triangle;
  std::string clipper, scalar;
  std::int64_t cases = 0, failures = 0, promises_broken = 0;
  std::string failing = {};  // the first of the cases that it fails on

  static constexpr std::string_view kName = "hard_cases";
  static constexpr std::string_view kTitle = "The catalogue of hard cases, by clipper";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Fails: the answer is not finite, has other vertices than the exact one, or is off by 1/256 px or more. Cases that a method does not take are not counted. Promises: see `clipscope list clippers`."};
  static constexpr auto columns() {
    using R = SummaryRow;
    return std::tuple(column("primitive", &R::primitive),
                      contestant_columns(&R::clipper, &R::scalar), column("cases", &R::cases),
                      column("failures", "fails", &R::failures),
                      column("promises_broken", "broken promises", &R::promises_broken),
                      column("failing", "fails on", &R::failing));
  }
};

void add_rows(const CaseSet& set, const Verdicts& verdicts, TableOf<VerdictRow>& table);
void add_rows(const CaseSet& set, const Verdicts& verdicts, TableOf<SummaryRow>& table);

// Which usual clipper fails on the smallest share of the triangles that it takes in float, which on
// the largest; who fails on none; and what exact arithmetic does not mend.
std::string finding(const std::vector<SummaryRow>& summary);

struct FamilyRow {
  Primitive primitive = Primitive::triangle;
  std::string clipper, scalar;
  FamilyTally tally;

  static constexpr std::string_view kName = "hard_cases_families";
  static constexpr std::string_view kTitle =
      "Families around the hard cases: 2^k scalings, rotations, mirrored axes, depth ranges, ulp neighbours, extreme values";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Largest error: backward error in units of the promise, u M (see spaces/clipper.hpp), where the promise speaks of the variant."};
  static constexpr auto columns() {
    using R = FamilyRow;
    using T = FamilyTally;
    return std::tuple(
        column("primitive", &R::primitive), contestant_columns(&R::clipper, &R::scalar),
        group(
            &R::tally,
            std::tuple(column("variants", &T::variants), column("failures", "fails", &T::failures),
                       column("promises_broken", "broken", &T::broken),
                       column("largest_backward_error", "largest error", &T::largest_ulps),
                       column("worst", "on", &T::worst),
                       column("offender", "first broken promise", &T::offender))));
  }
};

struct PolicyRow {
  Primitive primitive = Primitive::triangle;
  std::string clipper, scalar;
  PolicyTally tally;

  static constexpr std::string_view kName = "hard_cases_policy";
  static constexpr std::string_view kTitle = "NaN and infinity in positions: nothing may come out";
  static constexpr auto columns() {
    using R = PolicyRow;
    using T = PolicyTally;
    return std::tuple(
        column("primitive", &R::primitive), contestant_columns(&R::clipper, &R::scalar),
        group(&R::tally, std::tuple(column("inputs", &T::inputs), column("drawn", &T::drawn),
                                    column("offender", "first on", &T::offender))));
  }
};

// One tally per contestant.
template <class Row, class T>
void add_rows(const CaseSet& set, const std::vector<T>& tallies, TableOf<Row>& table) {
  for (std::size_t c = 0; c < tallies.size(); ++c) {
    const Contestant& contestant = *set.contestants[c];
    table.add({set.primitive, std::string(contestant.clipper), std::string(contestant.scalar()),
               tallies[c]});
  }
}

// The cases that notice a bug: those on which the textbook clipper with the bug
// (reference/mutants.hpp) differs from the reference.
std::vector<std::string> caught_by(reference::Bug bug, std::span<const HardCase> cases);

struct MutantRow {
  std::string bug;  // what the clipper does wrong
  std::int64_t caught_by = 0;
  std::string sharpest;  // the first of the cases that notice it and the fewest bugs else

  static constexpr std::string_view kName = "hard_cases_mutants";
  static constexpr std::string_view kTitle = "Seeded bugs, and how many cases notice them";
  static constexpr auto columns() {
    using R = MutantRow;
    return std::tuple(column("bug", &R::bug), column("caught_by", "caught by", &R::caught_by),
                      column("sharpest", "sharpest case", &R::sharpest));
  }
};

// One row per bug, in the order of all_bugs().
std::vector<MutantRow> mutant_rows(std::span<const HardCase> cases);

// How a plane predicate signs a grid of neighbouring floats.
struct SignRow {
  std::string grid, predicate;
  SignCounts counts;

  static constexpr std::string_view kName = "hard_cases_signs";
  static constexpr std::string_view kTitle =
      "Signs of plane predicates on 256 x 256 neighbouring floats around a point of a plane";
  static constexpr auto columns() {
    using R = SignRow;
    using C = SignCounts;
    return std::tuple(
        column("grid", &R::grid), column("predicate", &R::predicate),
        group(&R::counts, std::tuple(column("right", &C::right), column("opposite", &C::opposite),
                                     column("false_zero", "false zero", &C::false_zero),
                                     column("missed_zero", "missed zero", &C::missed_zero))));
  }
};

void add_rows(const UlpGrid& grid, TableOf<SignRow>& table);

}  // namespace clipscope::experiments::hard_cases

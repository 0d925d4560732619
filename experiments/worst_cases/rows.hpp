// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the worst cases' tables, and what is said of them at the end.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/contestants/columns.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/table/row.hpp"
#include "experiments/worst_cases/campaigns.hpp"
#include "experiments/worst_cases/chains.hpp"
#include "experiments/worst_cases/ties.hpp"

namespace clipscope::experiments::worst_cases {

// One record of a chain.
struct ChainRow {
  std::string clipper, scalar;
  Inputs inputs = Inputs::any;
  hunt::Measure measure = hunt::Measure::px;
  std::optional<double> kept, worst;
  Standing standing = Standing::kept;

  static constexpr std::string_view kName = "worst_cases_records";
  static constexpr std::string_view kTitle =
      "The records of the chains, and what this run made of them";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Kept: as the file of records has it. Worst: after the record was judged anew and a hunt began with it. Moved: the record has another figure now. The units are those of the table worst_cases, but for attribute: relative to the largest."};
  static constexpr auto columns() {
    using R = ChainRow;
    return std::tuple(contestant_columns(&R::clipper, &R::scalar), column("inputs", &R::inputs),
                      column("measure", &R::measure), column("kept", &R::kept),
                      column("worst", &R::worst), column("standing", "this run", &R::standing));
  }
};

// The largest errors of a chain.
struct WorstRow {
  std::string clipper, scalar;
  Inputs inputs = Inputs::any;
  std::optional<double> px, ulp, depth_ulp, attribute_ulp;

  static constexpr std::string_view kName = "worst_cases";
  static constexpr std::string_view kTitle =
      "The largest errors ever found of clippers that cut edge after edge";
  static constexpr std::array<std::string_view, 2> kNotes = {
      "Lower bounds of the worst, where the vertices are the right ones. px: position on a screen of 3840 x 2160. ulp: x, y, z and 1/w in ulp at the exact value, which is tiny next to 0. z: in ulp of 1. Attribute: in ulp of the triangle's largest.",
      "Inputs: any; in domain: the numbers stay in the format, and what is visible keeps away from the eye."};
  static constexpr auto columns() {
    using R = WorstRow;
    return std::tuple(contestant_columns(&R::clipper, &R::scalar), column("inputs", &R::inputs),
                      column("px", &R::px), column("ulp", &R::ulp),
                      column("depth_ulp", "z [ulp of 1]", &R::depth_ulp),
                      column("attribute_ulp", "attribute [ulp]", &R::attribute_ulp));
  }
};

enum class Ties : std::uint8_t { none, impossible, kept };
constexpr std::array<std::string_view, 3> names_of(Ties) { return {"none", "impossible", "kept"}; }

// One kind of number of the correctly rounded clipper.
struct TieRow {
  std::string kind;  // "clip: x or y, edge"
  std::optional<double> one_exponent_ulp = {}, any_exponents_ulp = {};
  double limit_ulp = 0;
  Ties ties = Ties::none;
  std::optional<double> chance_ulp = {};
  double expected_ulp = 0;
  std::size_t chance_numbers = 0, chance_ties = 0;
  Standing standing = Standing::kept;  // the one of its records that says most
  bool is_right = false;               // the clipper rounds the records right

  // Bits of the exact value behind the float that decide how it is rounded.
  std::optional<double> one_exponent_bits() const { return bits_of(one_exponent_ulp); }
  std::optional<double> any_exponents_bits() const { return bits_of(any_exponents_ulp); }
  std::optional<double> chance_bits() const { return bits_of(chance_ulp); }
  static std::optional<double> bits_of(std::optional<double> ulp);

  static constexpr std::string_view kName = "worst_cases_ties";
  static constexpr std::string_view kTitle =
      "The numbers nearest to a tie that the correctly rounded clipper rounds";
  static constexpr std::array<std::string_view, 2> kNotes = {
      "Distance of the exact value to the middle of two floats, in ulp, exact ties apart. A vertex is one of the triangle, an edge's with a plane, or the corner of two planes. One exponent: coordinates are multiples of a power of two, smaller than 2^24 times it; limit: no such number is nearer. Any exponents: the nearest found.",
      "By chance: the nearest of so many numbers of random triangles; expected: 1/(2 (n + 1)), as if distances were uniform. Impossible: a quotient of two floats is no tie unless it is subnormal."};
  static constexpr auto columns() {
    using R = TieRow;
    return std::tuple(column("kind", &R::kind),
                      column("one_exponent_ulp", "one exponent [ulp]", &R::one_exponent_ulp),
                      column("limit_ulp", "limit", &R::limit_ulp),
                      column("any_exponents_ulp", "any exponents [ulp]", &R::any_exponents_ulp),
                      column("ties", "exact ties", &R::ties),
                      column("chance_ulp", "by chance [ulp]", &R::chance_ulp),
                      column("expected_ulp", "expected", &R::expected_ulp),
                      column("chance_numbers", "numbers", &R::chance_numbers),
                      column("chance_ties", "ties", &R::chance_ties),
                      column("standing", "this run", &R::standing),
                      column("is_right", "rounded right", &R::is_right));
  }
};

std::string spoken_kind(const TieKind& kind);

// A row for each chain and its inputs, in the order of the records.
std::vector<WorstRow> worst_rows(const std::vector<ChainRow>& records);

// By kind, in bits behind the float.
Plot tie_plot(const std::vector<TieRow>& ties);

// The answer to the question.
std::string finding(const std::vector<WorstRow>& worst, const std::vector<TieRow>& ties,
                    const std::vector<CampaignRow>& campaigns);

}  // namespace clipscope::experiments::worst_cases

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The figures that decide a claim, case by case, each beside the bound that it has to keep.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "experiments/claims/words.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments::claims {

enum class Relation : std::uint8_t { above, below, at_least, at_most, not_below, equal };

// What a figure has to be. All of its interval has to, with two exceptions: a limit (at most) is
// kept by the figure itself, and `not_below` gives the claim the benefit of the doubt, so that it
// is enough if the interval reaches the value.
struct Bound {
  Relation relation = Relation::equal;
  double value = 0;

  bool admits(const MedianInterval& figure) const {
    switch (relation) {
      case Relation::above: return figure.low > value;
      case Relation::below: return figure.high < value;
      case Relation::at_least: return figure.low >= value;
      case Relation::at_most: return figure.median <= value;
      case Relation::not_below: return figure.high >= value;
      default: return figure.low == value && figure.high == value;
    }
  }
  std::string text() const {
    constexpr std::array<std::string_view, 6> kWords = {"above ",   "below ",     "at least ",
                                                        "at most ", "not below ", ""};
    return fmt::format("{}{}", kWords[static_cast<std::size_t>(relation)], number_text(value));
  }
};

constexpr Bound above(double value) { return {Relation::above, value}; }
constexpr Bound below(double value) { return {Relation::below, value}; }
constexpr Bound at_least(double value) { return {Relation::at_least, value}; }
constexpr Bound at_most(double value) { return {Relation::at_most, value}; }
constexpr Bound not_below(double value) { return {Relation::not_below, value}; }
constexpr Bound exactly(double value) { return {Relation::equal, value}; }

// The ratio of two figures whose intervals are independent.
constexpr MedianInterval ratio(const MedianInterval& a, const MedianInterval& b) {
  return {a.median / b.median, a.low / b.high, a.high / b.low};
}

// A measured number or a count; these are written without a point.
struct Figure {
  double value = 0;

  operator double() const { return value; }
};

}  // namespace clipscope::experiments::claims

namespace clipscope::experiments {

template <>
struct CellOf<claims::Figure> {
  static Cell write(const claims::Figure& figure) {
    constexpr double kAllCounts = 1e15;  // beyond, doubles have no room for a fraction
    const bool is_count = std::abs(figure) < kAllCounts && figure == std::floor(figure);
    return is_count ? Cell(static_cast<std::int64_t>(figure)) : Cell(figure.value);
  }
  static claims::Figure read(const Cell& cell) {
    if (const auto number = number_of(cell)) return {*number};
    throw MissingFigure("a figure is no number");
  }
};

}  // namespace clipscope::experiments

namespace clipscope::experiments::claims {

// A row of the table.
struct Evidence {
  struct Ends {
    double low = 0, high = 0;
  };

  int claim = 0;
  std::string of, what;  // the case, by the name that the tables give it, and what is measured
  Figure figure;
  std::optional<Ends> ends = {};  // of the 95 % interval
  std::string unit = {};
  std::optional<std::string> bound = {};  // nothing: the figure is told, and decides nothing
  std::optional<bool> holds = {};

  static constexpr std::string_view kName = "claims_evidence";
  static constexpr std::string_view kTitle = "The figures that decide each claim";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Holds: the figure is what it must be, and so is all of its 95 % interval, but for a limit (at most), and for not below, which some of it may reach. A figure without a bound decides nothing."};
  static constexpr auto columns() {
    using R = Evidence;
    return std::tuple(
        column("claim", &R::claim), column("case", "case", &R::of, 14),
        column("what", "what", &R::what, 22), column("figure", &R::figure),
        NumberColumns<R, std::optional<Ends>>{
            &R::ends, {{{"figure", "_low", "95 % low", ""}, {"figure", "_high", "high", ""}}}},
        column("unit", "unit", &R::unit, 8), column("bound", "must be", &R::bound, 8),
        column("holds", &R::holds));
  }
};

// A figure that decides nothing alone.
inline Evidence told(std::string of, std::string what, double figure, std::string unit) {
  return {
      .of = std::move(of), .what = std::move(what), .figure = {figure}, .unit = std::move(unit)};
}

inline Evidence decided(std::string of, std::string what, double figure, std::string unit,
                        const Bound& bound) {
  Evidence evidence = told(std::move(of), std::move(what), figure, std::move(unit));
  evidence.bound = bound.text();
  evidence.holds = bound.admits({figure, figure, figure});
  return evidence;
}

inline Evidence decided(std::string of, std::string what, const MedianInterval& figure,
                        std::string unit, const Bound& bound) {
  Evidence evidence =
      decided(std::move(of), std::move(what), figure.median, std::move(unit), bound);
  evidence.ends = {figure.low, figure.high};
  evidence.holds = bound.admits(figure);
  return evidence;
}

}  // namespace clipscope::experiments::claims

// SPDX-License-Identifier: GPL-3.0-or-later
//
// What papers on clipping say of divisions, growth and rounding, each run again.
#include <algorithm>
#include <cmath>

#include "experiments/claims/ranking.hpp"
#include "experiments/frontier/rows.hpp"
#include "experiments/segments/convex_windows.hpp"
#include "experiments/segments/literature.hpp"

namespace clipscope::experiments::claims {
namespace {

using segments::ConvexRow;
using segments::PlaneRow;

// In the plane the method divides no more often than each of the others, mix by mix.
auto divides_least(std::string_view method, std::vector<std::string_view> others) {
  return [=](const Results& results) {
    const auto divisions = [&](const std::string& mix, std::string_view clipper) {
      return results
          .figures<PlaneRow>(&PlaneRow::divisions, &PlaneRow::mix, mix, &PlaneRow::clipper, clipper)
          .front();
    };
    Cases cases;
    for (const std::string& mix : distinct(results.rows<PlaneRow>(), &PlaneRow::mix)) {
      double least = HUGE_VAL;
      for (const std::string_view other : others) least = std::min(least, divisions(mix, other));
      const double own = divisions(mix, method);
      cases.add(mix, own <= least, fmt::format("{} {:.2f}/{:.2f}", mix, own, least));
    }
    return cases.judge("The mix is {}. ", "Divisions per segment, its own/the fewest of {}: {}.",
                       fmt::join(others, ", "), cases.figures(", "));
  };
}

Judgement midpoints_without_division(const Results& results) {
  constexpr std::string_view kMidpoints = "window/midpoint_subdivision";
  const auto most = [&](auto member) {
    return std::ranges::max(results.figures<PlaneRow>(member, &PlaneRow::clipper, kMidpoints));
  };
  const double divisions = most(&PlaneRow::divisions);
  return confirmed_if(
      divisions == 0,
      "Most divisions per segment of any mix: {:.3g}; for these it halves up to {:.0f} times and compares up to {:.0f} times.",
      divisions, most(&PlaneRow::multiplications), most(&PlaneRow::comparisons));
}

// How the cost of a method rises from the smallest polygon to the largest.
Judgement constant_in_edges(const Results& results) {
  constexpr double kConstant = 1.5;
  const std::vector<double> ns = results.figures<ConvexRow>(
      [](const ConvexRow& row) {
        return row.timing ? std::optional(row.timing->ns.median) : std::nullopt;
      },
      &ConvexRow::method, "convex/dual_subdivision");
  return confirmed_if(
      ns.back() <= kConstant * ns.front(),
      "From the fewest edges to the most the time goes from {:.3g} to {:.3g} ns (constant: at most {} times).",
      ns.front(), ns.back(), kConstant);
}

Judgement two_divisions(const Results& results) {
  const std::vector<double> divisions =
      results.figures<ConvexRow>(&ConvexRow::divisions, &ConvexRow::method, "convex/skala");
  const double most = std::ranges::max(divisions);
  return confirmed_if(most <= 2,
                      "Divisions per segment, over all numbers of edges: at most {:.3g}.", most);
}

Judgement pruning_computes_less(const Results& results) {
  using R = segments::OperationsRow;
  Cases cases;
  for (const std::string& mix : distinct(results.rows<R>(), &R::mix)) {
    const auto divisions = [&](std::string_view clipper) {
      return results.figures<R>(&R::cut_divisions, &R::mix, mix, &R::clipper, clipper).front();
    };
    const double own = divisions("homogeneous/pruning"),
                 other = divisions("homogeneous/cyrus_beck");
    cases.add(mix, own < other, fmt::format("{} {:.2f}/{:.2f}", mix, own, other));
  }
  return cases.judge("The mix is {}. ", "Cut divisions per segment, pruning/Cyrus-Beck: {}.",
                     cases.figures(", "));
}

// Of coordinates that a polygon has in float, as many are the nearest floats as with any other end
// to interpolate from, or more.
Judgement nearer_end_rounds_best(const Results& results) {
  using R = frontier::Row;
  Cases cases;
  for (const std::string& set : distinct(results.rows<R>(), &R::set)) {
    const auto right = [&](std::string_view clipper) {
      return results
          .figures<R>(&R::correctly_rounded_percent, &R::set, set, &R::contract, Contract::full,
                      &R::clipper, clipper, &R::scalar, "float")
          .front();
    };
    const double inside = right(kClipSpace), outside = right("homogeneous/from_outside");
    const double weighted = right("homogeneous/weighted_ends");
    const double nearer = right("homogeneous/nearer_end");
    cases.add(
        set, nearer >= std::max({inside, outside, weighted}),
        fmt::format("{} {:.2f}/{:.2f}/{:.2f}/{:.2f}", set, nearer, inside, outside, weighted));
  }
  return cases.judge(
      "The set is {}. ",
      "Coordinates rounded right, in percent, from the nearer end/the inside end/the outside end/weighted ends: {}.",
      cases.figures(", "));
}

std::string_view experiment_of(Field field) {
  return field == Field::triangles || field == Field::stage ? "cost" : "segments";
}

}  // namespace

std::vector<Claim> claims_of_the_literature() {
  const std::vector<std::string_view> usual = {"window/cohen_sutherland", "window/liang_barsky"};
  std::vector<Claim> claims;
  for (const Ranking& ranking : published_rankings()) {
    claims.push_back({ranking.number, ranking.statement, experiment_of(ranking.field),
                      [ranking](const Results& results) { return judge(ranking, results); }});
  }
  const auto add = [&](int number, std::string_view statement,
                       std::function<Judgement(const Results&)> judge,
                       std::string_view experiment = "segments") {
    claims.push_back({number, statement, experiment, std::move(judge)});
  };
  add(38,
      "Nicholl-Lee-Nicholl divides least, beside Cohen-Sutherland and Liang-Barsky (Nicholl, Lee and Nicholl 1987).",
      divides_least("window/nicholl_lee_nicholl", usual));
  add(51, "Midpoint subdivision clips without a division (Sproull and Sutherland 1968).",
      midpoints_without_division);
  add(52,
      "The homogeneous formulation spares divisions, beside Cohen-Sutherland and Liang-Barsky (Skala 2005).",
      divides_least("window/skala", usual));
  add(53, "By a convex polygon two divisions are enough, whatever its edges (Skala 1993).",
      two_divisions);
  add(54, "After preparation a convex polygon clips in constant time (Skala 1996).",
      constant_in_edges);
  add(55,
      "Pruning spares the intersections that Cyrus-Beck computes in vain (Wijeweera and Kodituwakku 2016).",
      pruning_computes_less);
  add(61,
      "Interpolating from the nearer end loses least (practice: S2 Geometry, Manifold, with a proof).",
      nearer_end_rounds_best, "frontier");
  return claims;
}

}  // namespace clipscope::experiments::claims

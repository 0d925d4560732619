// SPDX-License-Identifier: GPL-3.0-or-later
//
// What papers on clipping say of divisions, growth and rounding, each run again.
#include <algorithm>
#include <cmath>

#include "experiments/claims/ranking.hpp"
#include "experiments/contestants/spoken.hpp"
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
    Cases cases(spoken_lines);
    for (const std::string& mix : distinct(results.rows<PlaneRow>(), &PlaneRow::mix)) {
      double least = HUGE_VAL;
      for (const std::string_view other : others) least = std::min(least, divisions(mix, other));
      cases.add(decided(mix, "divisions, against the fewest of the others", divisions(mix, method),
                        "per segment", at_most(least)));
    }
    const std::string name = spoken_methods(method, others)[0], most = number_text(cases.most());
    return cases.judge(
        {fmt::format("{} divides at most {} times per segment, no more than the others on any mix.",
                     name, most),
         fmt::format("{}; elsewhere {} divides more often, up to {} times per segment.",
                     cases.where(), name, number_text(cases.most_failing())),
         fmt::format("{} divides more often than another on every mix.", name)});
  };
}

Judgement midpoints_without_division(const Results& results) {
  constexpr std::string_view kMidpoints = "window/midpoint_subdivision";
  const auto most = [&](auto member) {
    return std::ranges::max(results.figures<PlaneRow>(member, &PlaneRow::clipper, kMidpoints));
  };
  const double divisions = most(&PlaneRow::divisions), halvings = most(&PlaneRow::multiplications);
  const double comparisons = most(&PlaneRow::comparisons);
  constexpr const char* kUnit = "per segment";
  return judged(
      {decided("all mixes", "most divisions of any mix", divisions, kUnit, exactly(0)),
       told("all mixes", "most halvings of any mix", halvings, kUnit),
       told("all mixes", "most comparisons of any mix", comparisons, kUnit)},
      false,
      {fmt::format(
           "Midpoint subdivision never divides, but halves up to {} times per segment and compares up to {} times.",
           number_text(halvings), number_text(comparisons)),
       "",
       fmt::format("Midpoint subdivision divides up to {} times per segment.",
                   number_text(divisions))});
}

// How the cost of a method rises from the smallest polygon to the largest.
Judgement constant_in_edges(const Results& results) {
  constexpr double kConstant = 1.5;  // times the smallest polygon's
  const std::vector<ConvexRow> rows =
      rows_where(results.rows<ConvexRow>(), &ConvexRow::method, "convex/dual_subdivision");
  std::vector<Evidence> evidence;
  double first = 0, most = 0;
  for (const ConvexRow& row : rows) {
    if (!row.timing) continue;
    const double ns = row.timing->ns.median;
    if (evidence.empty()) first = ns;
    evidence.push_back(
        decided(edges_name(row.edges), "time", ns, "ns", at_most(kConstant * first)));
    most = std::max(most, ns);
  }
  if (evidence.empty()) throw MissingFigure("table segments_convex has no time of the dual plane");
  return judged(
      std::move(evidence), false,
      {fmt::format("The time stays between {} ns and {} ns, whatever the number of edges.",
                   number_text(std::min(first, most)), number_text(most)),
       "",
       fmt::format("The time grows from {} ns to {} ns with the number of edges.",
                   number_text(first), number_text(most))});
}

Judgement two_divisions(const Results& results) {
  std::vector<Evidence> evidence;
  double most = 0;
  for (const ConvexRow& row :
       rows_where(results.rows<ConvexRow>(), &ConvexRow::method, "convex/skala")) {
    evidence.push_back(
        decided(edges_name(row.edges), "divisions", row.divisions, "per segment", at_most(2)));
    most = std::max(most, row.divisions);
  }
  if (evidence.empty()) throw MissingFigure("table segments_convex has no row of convex/skala");
  return judged(
      std::move(evidence), false,
      {fmt::format("No polygon takes more than {} divisions per segment.", number_text(most)), "",
       fmt::format("A polygon takes up to {} divisions per segment.", number_text(most))});
}

Judgement pruning_computes_less(const Results& results) {
  using R = segments::OperationsRow;
  Cases cases(spoken_lines);
  for (const std::string& mix : distinct(results.rows<R>(), &R::mix)) {
    const auto divisions = [&](std::string_view clipper) {
      return results.figures<R>(&R::cut_divisions, &R::mix, mix, &R::clipper, clipper).front();
    };
    cases.add(decided(mix, "divisions of cuts, against those of Cyrus-Beck",
                      divisions("homogeneous/pruning"), "per segment",
                      below(divisions("homogeneous/cyrus_beck"))));
  }
  const std::string most = number_text(cases.most());
  return cases.judge(
      {fmt::format(
           "Pruning divides less than Cyrus-Beck on every mix, at most {} times per segment.",
           most),
       fmt::format("{}; elsewhere pruning divides as often as Cyrus-Beck, up to {} times.",
                   cases.where(), number_text(cases.most_failing())),
       "Pruning divides as often as Cyrus-Beck on every mix, or more often."});
}

// Of coordinates that a polygon has in float, as many are the nearest floats as with any other end
// to interpolate from, or more.
Judgement nearer_end_rounds_best(const Results& results) {
  using R = frontier::Row;
  Cases cases;
  double gain = 0, loss = 0;  // in points of a percentage
  for (const std::string& set : distinct(results.rows<R>(), &R::set)) {
    const auto right = [&](std::string_view clipper) {
      return results
          .figures<R>(&R::correctly_rounded_percent, &R::set, set, &R::contract, Contract::full,
                      &R::clipper, clipper, &R::scalar, "float")
          .front();
    };
    const double best =
        std::max({right("homogeneous/from_inside"), right("homogeneous/from_outside"),
                  right("homogeneous/weighted_ends")});
    const double nearer = right(kClipSpace);
    cases.add(decided(set, "coordinates rounded right, against the best of the other ends", nearer,
                      "%", at_least(best)));
    gain = std::max(gain, nearer - best);
    loss = std::max(loss, best - nearer);
  }
  return cases.judge(
      {fmt::format(
           "From the nearer end as many coordinates are rounded right as from any other, or up to {} % more.",
           number_text(gain)),
       fmt::format("{}; elsewhere another end rounds up to {} % more of the coordinates right.",
                   cases.where(), number_text(loss)),
       fmt::format(
           "Another end rounds up to {} % more of the coordinates right, on every set some more.",
           number_text(loss))});
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

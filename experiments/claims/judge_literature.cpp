// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rankings that papers on clipping publish, and what they say of divisions, each run again.
#include <algorithm>
#include <cmath>
#include <span>

#include "experiments/claims/ranking.hpp"
#include "experiments/cost/rows.hpp"
#include "experiments/frontier/rows.hpp"
#include "experiments/segments/convex_windows.hpp"
#include "experiments/segments/literature.hpp"

namespace clipscope::experiments::claims {
namespace {

using segments::ConvexRow;
using segments::PlaneRow;

constexpr std::string_view kPlaneCohenSutherland = "window/cohen_sutherland";
constexpr std::string_view kPlaneLiangBarsky = "window/liang_barsky";
constexpr std::string_view kPlaneCyrusBeck = "window/cyrus_beck";
constexpr std::string_view kNichollLeeNicholl = "window/nicholl_lee_nicholl";
constexpr std::string_view kKodituwakku = "window/kodituwakku_wijeweera_chamikara";
constexpr std::string_view kConvexCyrusBeck = "convex/cyrus_beck";
constexpr std::string_view kConvexPruning = "convex/pruning";
constexpr std::string_view kMaillot = "window/maillot";
constexpr std::string_view kLiangBarskyPolygon = "window/liang_barsky_polygon";

bool is_box(const std::string& mix) { return mix.starts_with("box_"); }

// How many of the mixes of a kind a ranking holds on.
struct Held {
  int holds = 0, all = 0;

  void add(bool held) {
    ++all;
    holds += held;
  }
};

// In the plane, the paper's kind of input and ours apart: what differs is whether branches can be
// predicted.
std::string by_kind_text(const Held& boxes, const Held& classes) {
  if (boxes.all == 0 || classes.all == 0) return "";
  return fmt::format(
      " It holds on {} of {} boxes, where no branch can be predicted, and on {} of {} mixes of one kind, where all can.",
      boxes.holds, boxes.all, classes.holds, classes.all);
}

// Who was timed in float on what, and how many times faster than the table's baseline he was there.
struct TimedRow {
  std::string mix;
  std::string_view clipper;
  const std::optional<Timing>& timing;
};

template <class MixRow>
std::vector<TimedRow> timed_by_mix(const Results& results) {
  std::vector<TimedRow> rows;
  for (const MixRow& row : results.rows<MixRow>()) {
    if (row.scalar == "float") rows.push_back({row.mix, row.clipper, row.timing});
  }
  return rows;
}

std::vector<TimedRow> timed_by_edges(const Results& results) {
  std::vector<TimedRow> rows;
  for (const ConvexRow& row : results.rows<ConvexRow>()) {
    rows.push_back({fmt::format("{} edges", row.edges), row.method, row.timing});
  }
  return rows;
}

std::vector<TimedRow> timed_rows(Field field, const Results& results) {
  switch (field) {
    case Field::plane: return timed_by_mix<PlaneRow>(results);
    case Field::segments: return timed_by_mix<segments::TimeRow>(results);
    case Field::convex_windows: return timed_by_edges(results);
    default: return timed_by_mix<cost::Row>(results);
  }
}

MedianInterval speedup_of(std::span<const TimedRow> rows, const std::string& mix,
                          std::string_view clipper) {
  for (const TimedRow& row : rows) {
    if (row.mix != mix || row.clipper != clipper) continue;
    if (row.timing && row.timing->speedup) return *row.timing->speedup;
  }
  throw MissingFigure(fmt::format("no table has a time of {} on {}", clipper, mix));
}

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
  return field == Field::triangles ? "cost" : "segments";
}

}  // namespace

Judgement judge(const Ranking& ranking, const Results& results) {
  const std::vector<TimedRow> rows = timed_rows(ranking.field, results);
  Cases cases;
  Held boxes, classes;
  std::vector<std::string> mixes;
  for (const TimedRow& row : rows) {
    if (std::ranges::find(mixes, row.mix) == mixes.end()) mixes.push_back(row.mix);
  }
  for (const std::string& mix : mixes) {
    const MedianInterval method = speedup_of(rows, mix, ranking.method);
    double least = HUGE_VAL;
    bool holds = true;
    for (const std::string_view other : ranking.others) {
      const MedianInterval rival = speedup_of(rows, mix, other);
      least = std::min(least, method.median / rival.median);
      holds = holds && method.low > ranking.times_as_fast * rival.high;
    }
    cases.add(mix, holds, fmt::format("{} {:.2f}", mix, least));
    if (ranking.field == Field::plane) (is_box(mix) ? boxes : classes).add(holds);
  }
  return cases.judge("The mix is {}. ", "Times as fast as {}{}: {}.{}",
                     ranking.others.size() == 1 ? "" : "the fastest of ",
                     fmt::join(ranking.others, ", "), cases.figures(", "),
                     by_kind_text(boxes, classes));
}

std::vector<Ranking> published_rankings() {
  return {
      {34,
       "Liang-Barsky clips random segments in 2D 36 % faster than Cohen-Sutherland (Liang and Barsky 1984).",
       Field::plane,
       kPlaneLiangBarsky,
       {kPlaneCohenSutherland},
       1.36},
      {35,
       "In 3D Liang-Barsky is 40 % faster than Cohen-Sutherland (Liang and Barsky 1984).",
       Field::segments,
       "cvv/liang_barsky",
       {"cvv/cohen_sutherland"},
       1.40},
      {36,
       "In homogeneous coordinates Liang-Barsky is 79 % faster than Cohen-Sutherland (Liang and Barsky 1984).",
       Field::segments,
       "homogeneous/liang_barsky",
       {"homogeneous/cohen_sutherland"},
       1.79},
      {37,
       "Nicholl-Lee-Nicholl is the fastest in 2D, beside Cohen-Sutherland and Liang-Barsky (Nicholl, Lee and Nicholl 1987).",
       Field::plane,
       kNichollLeeNicholl,
       {kPlaneCohenSutherland, kPlaneLiangBarsky}},
      {39,
       "Matthes-Drakopoulos is faster than Cohen-Sutherland, Cyrus-Beck, Liang-Barsky, Nicholl-Lee-Nicholl, Skala and Kodituwakku-Wijeweera-Chamikara (Matthes and Drakopoulos 2019).",
       Field::plane,
       "window/matthes_drakopoulos",
       {kPlaneCohenSutherland, kPlaneCyrusBeck, kPlaneLiangBarsky, kNichollLeeNicholl,
        "window/skala", kKodituwakku}},
      {40,
       "Kodituwakku-Wijeweera-Chamikara is 13 % faster than Cohen-Sutherland (Kodituwakku, Wijeweera and Chamikara 2013).",
       Field::plane,
       kKodituwakku,
       {kPlaneCohenSutherland},
       1.13},
      {41,
       "Kodituwakku-Wijeweera-Chamikara is 7 % faster than Liang-Barsky (Kodituwakku, Wijeweera and Chamikara 2013).",
       Field::plane,
       kKodituwakku,
       {kPlaneLiangBarsky},
       1.07},
      {42,
       "A case for each pair of regions spares Cohen-Sutherland's iterations and is faster (Sobkow, Pospisil and Yang 1987).",
       Field::plane,
       "window/sobkow_pospisil_yang",
       {kPlaneCohenSutherland}},
      {43,
       "Liang-Barsky is 55 % faster than Cohen-Sutherland and more, with boxes of 1 to 21 times the window (practice: datashader 2017).",
       Field::plane,
       kPlaneLiangBarsky,
       {kPlaneCohenSutherland},
       1.55},
      {44,
       "Liang-Barsky is faster than Cyrus-Beck (Foley, van Dam, Feiner and Hughes 1990).",
       Field::plane,
       kPlaneLiangBarsky,
       {kPlaneCyrusBeck}},
      {45,
       "Boundary coordinates unite the best of Cohen-Sutherland, Cyrus-Beck and Liang-Barsky in one efficient line clipper (Blinn 1991).",
       Field::segments,
       "homogeneous/blinn",
       {"homogeneous/cohen_sutherland", "homogeneous/cyrus_beck", "homogeneous/liang_barsky"}},
      {46,
       "Two planes through the line clip by a polyhedron faster than Cyrus-Beck (Skala 1996).",
       Field::segments,
       "cvv/skala_polyhedron",
       {"homogeneous/cyrus_beck"}},
      {47,
       "Halving the boundary clips by a convex polygon faster than Cyrus-Beck (Skala 1994).",
       Field::convex_windows,
       "convex/skala_logarithmic",
       {kConvexCyrusBeck}},
      {48,
       "Pruning clips by a convex polygon faster than Cyrus-Beck (Wijeweera, Kodituwakku and Chamikara 2019).",
       Field::convex_windows,
       kConvexPruning,
       {kConvexCyrusBeck}},
      {49,
       "Skala's edge test of 1993 is faster than pruning (Wijeweera, Kodituwakku and Chamikara 2019).",
       Field::convex_windows,
       "convex/skala",
       {kConvexPruning}},
      {50,
       "By a convex polygon nobody clips faster than Cyrus-Beck (Wijeweera, Kodituwakku and Chamikara 2017).",
       Field::convex_windows,
       kConvexCyrusBeck,
       {kConvexPruning, "convex/skala", "convex/skala_logarithmic", "convex/skala_homogeneous",
        "convex/extreme_vertices"}},
      {56,
       "Maillot's polygon clipper is faster than Sutherland-Hodgman, up to eight times (Maillot 1992).",
       Field::triangles,
       kMaillot,
       {kCvv}},
      {57,
       "Maillot's polygon clipper is faster than Liang-Barsky's, up to three times (Maillot 1992).",
       Field::triangles,
       kMaillot,
       {kLiangBarskyPolygon}},
      {58,
       "Liang-Barsky's polygon clipper is faster than Sutherland-Hodgman (Liang and Barsky 1983).",
       Field::triangles,
       kLiangBarskyPolygon,
       {kCvv}},
      {59,
       "On a vector processor clipping in registers is five times as fast as direct Sutherland-Hodgman (McGuire 2011).",
       Field::triangles,
       "homogeneous/mcguire_batch",
       {kClipSpace},
       5},
      {60,
       "Two opposite planes in one pass are faster than one after the other (practice of rasterisers).",
       Field::triangles,
       "homogeneous/opposite_planes",
       {kClipSpace}},
  };
}

std::vector<Claim> claims_of_the_literature() {
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
      divides_least(kNichollLeeNicholl, {kPlaneCohenSutherland, kPlaneLiangBarsky}));
  add(51, "Midpoint subdivision clips without a division (Sproull and Sutherland 1968).",
      midpoints_without_division);
  add(52,
      "The homogeneous formulation spares divisions, beside Cohen-Sutherland and Liang-Barsky (Skala 2005).",
      divides_least("window/skala", {kPlaneCohenSutherland, kPlaneLiangBarsky}));
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

std::string winners_text(const std::vector<Row>& claims) {
  int everywhere = 0, somewhere = 0, nowhere = 0;
  for (const Ranking& ranking : published_rankings()) {
    const Row* row = find_row(claims, &Row::number, ranking.number);
    if (row == nullptr) continue;
    everywhere += row->verdict == Verdict::confirmed;
    somewhere += row->verdict == Verdict::conditional;
    nowhere += row->verdict == Verdict::refuted;
  }
  const int all = everywhere + somewhere + nowhere;
  if (all == 0) return "";
  return fmt::format(
      "Of {} published rankings that were run again the winner wins everywhere in {}, on some mixes in {}, nowhere in {}.",
      all, everywhere, somewhere, nowhere);
}

}  // namespace clipscope::experiments::claims

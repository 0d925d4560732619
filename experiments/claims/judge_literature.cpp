// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rankings that papers on clipping publish, and what they say of divisions, each run again.
#include <algorithm>
#include <array>

#include "experiments/claims/ranking.hpp"
#include "experiments/claims/speed.hpp"
#include "experiments/cost/rows.hpp"
#include "experiments/segments/literature.hpp"

namespace clipscope::experiments::claims {
namespace {

using segments::PlaneRow;

constexpr std::string_view kPlaneCohenSutherland = "window/cohen_sutherland";
constexpr std::string_view kPlaneLiangBarsky = "window/liang_barsky";
constexpr std::string_view kNichollLeeNicholl = "window/nicholl_lee_nicholl";

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

template <class MixRow>
Judgement judge_in(const Ranking& ranking, const Results& results) {
  Cases cases;
  Held boxes, classes;
  for (const std::string& mix : distinct(results.rows<MixRow>(), &MixRow::mix)) {
    const Speed method = speed<MixRow>(results, mix, ranking.method);
    double least = HUGE_VAL;
    bool holds = true;
    for (const std::string_view other : ranking.others) {
      const Speed rival = speed<MixRow>(results, mix, other);
      least = std::min(least, method.speedup.median / rival.speedup.median);
      holds = holds && method.speedup.low > ranking.times_as_fast * rival.speedup.high;
    }
    cases.add(mix, holds, fmt::format("{} {:.2f}", mix, least));
    if (ranking.field == Field::plane) (is_box(mix) ? boxes : classes).add(holds);
  }
  return cases.judge("The mix is {}. ", "Times as fast as {}{}: {}.{}",
                     ranking.others.size() == 1 ? "" : "the fastest of ",
                     fmt::join(ranking.others, ", "), cases.figures(", "),
                     by_kind_text(boxes, classes));
}

// Divisions per segment in the plane, by mix: fewer than each of the others', or as few.
Judgement divides_least(const Results& results) {
  constexpr std::array kOthers = {kPlaneCohenSutherland, kPlaneLiangBarsky};
  Cases cases;
  for (const std::string& mix : distinct(results.rows<PlaneRow>(), &PlaneRow::mix)) {
    const auto divisions = [&](std::string_view clipper) {
      return results
          .figures<PlaneRow>(&PlaneRow::divisions, &PlaneRow::mix, mix, &PlaneRow::clipper, clipper)
          .front();
    };
    const double own = divisions(kNichollLeeNicholl);
    const double least = std::min(divisions(kOthers[0]), divisions(kOthers[1]));
    cases.add(mix, own <= least, fmt::format("{} {:.2f}/{:.2f}", mix, own, least));
  }
  return cases.judge("The mix is {}. ",
                     "Divisions per segment, Nicholl-Lee-Nicholl/the fewer of the other two: {}.",
                     cases.figures(", "));
}

}  // namespace

Judgement judge(const Ranking& ranking, const Results& results) {
  switch (ranking.field) {
    case Field::plane: return judge_in<PlaneRow>(ranking, results);
    case Field::segments: return judge_in<segments::TimeRow>(ranking, results);
    default: return judge_in<cost::Row>(ranking, results);
  }
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
  };
}

std::vector<Claim> claims_of_the_literature() {
  std::vector<Claim> claims;
  for (const Ranking& ranking : published_rankings()) {
    claims.push_back({ranking.number, ranking.statement,
                      ranking.field == Field::triangles ? "cost" : "segments",
                      [ranking](const Results& results) { return judge(ranking, results); }});
  }
  claims.push_back(
      {38,
       "Nicholl-Lee-Nicholl divides least, beside Cohen-Sutherland and Liang-Barsky (Nicholl, Lee and Nicholl 1987).",
       "segments", divides_least});
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

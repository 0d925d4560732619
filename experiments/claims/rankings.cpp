// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rankings that papers on clipping publish, each run again.
#include <algorithm>
#include <cmath>
#include <span>

#include "experiments/claims/ranking.hpp"
#include "experiments/cost/rows.hpp"
#include "experiments/segments/convex_windows.hpp"
#include "experiments/segments/literature.hpp"

namespace clipscope::experiments::claims {
namespace {

using segments::ConvexRow;
using segments::PlaneRow;

constexpr std::string_view kPlaneCohenSutherland = "window/cohen_sutherland";
constexpr std::string_view kPlaneCyrusBeck = "window/cyrus_beck";
constexpr std::string_view kPlaneLiangBarsky = "window/liang_barsky";
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

// Batch clippers in SIMD, the others as they are. The baseline is timed where nobody else is.
std::vector<TimedRow> timed_in_stage(const Results& results) {
  std::vector<TimedRow> rows;
  for (const cost::StageRow& row : results.rows<cost::StageRow>()) {
    if (row.scalar != "float" || row.contract != name_of(Contract::copy)) continue;
    if (row.build == "plain" || row.clipper == "textbook") continue;
    rows.push_back({row.mix, row.clipper, row.timing});
  }
  return rows;
}

std::vector<TimedRow> timed_rows(Field field, const Results& results) {
  switch (field) {
    case Field::plane: return timed_by_mix<PlaneRow>(results);
    case Field::segments: return timed_by_mix<segments::TimeRow>(results);
    case Field::convex_windows: return timed_by_edges(results);
    case Field::stage: return timed_in_stage(results);
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
       Field::stage,
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

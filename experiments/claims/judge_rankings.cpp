// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a published ranking is judged by the times of a run.
#include <algorithm>
#include <optional>
#include <span>

#include "experiments/claims/ranking.hpp"
#include "experiments/contestants/spoken.hpp"
#include "experiments/cost/rows.hpp"
#include "experiments/segments/convex_windows.hpp"
#include "experiments/segments/literature.hpp"
#include "experiments/table/prose.hpp"

namespace clipscope::experiments::claims {
namespace {

// Who was timed in float on what, and how many times faster than the table's baseline he was there.
struct TimedRow {
  std::string mix;
  std::string_view clipper;
  std::optional<MedianInterval> speedup;
};

template <class T>
std::optional<MedianInterval> speedup_of(const std::optional<T>& timing) {
  return timing ? timing->speedup : std::nullopt;
}

template <class MixRow>
std::vector<TimedRow> timed_by_mix(const Results& results) {
  std::vector<TimedRow> rows;
  for (const MixRow& row : results.rows<MixRow>()) {
    if (row.scalar == "float") rows.push_back({row.mix, row.clipper, speedup_of(row.timing)});
  }
  return rows;
}

std::vector<TimedRow> timed_by_edges(const Results& results) {
  std::vector<TimedRow> rows;
  for (const segments::ConvexRow& row : results.rows<segments::ConvexRow>()) {
    rows.push_back({edges_name(row.edges), row.method, speedup_of(row.timing)});
  }
  return rows;
}

// Batch clippers in SIMD, the others as they are. The baseline is timed where nobody else is.
std::vector<TimedRow> timed_in_stage(const Results& results) {
  std::vector<TimedRow> rows;
  for (const cost::StageRow& row : results.rows<cost::StageRow>()) {
    if (row.scalar != "float" || row.contract != name_of(Contract::copy)) continue;
    if (row.from != InputFrom::memory) continue;
    if (row.build == "plain" || row.clipper == "textbook") continue;
    rows.push_back({row.mix, row.clipper, speedup_of(row.timing)});
  }
  return rows;
}

std::vector<TimedRow> timed_rows(Field field, const Results& results) {
  switch (field) {
    case Field::plane: return timed_by_mix<segments::PlaneRow>(results);
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
    if (row.speedup) return *row.speedup;
  }
  throw MissingFigure(fmt::format("no table has a time of {} on {}", clipper, mix));
}

// The names of a method and its rivals in a sentence.
struct Names {
  std::string method, rival;
};

Names spoken_names(const Ranking& ranking) {
  const std::vector<std::string> names = spoken_methods(ranking.method, ranking.others);
  return {names[0], names.size() > 2 ? "the best of the others" : names[1]};
}

// The method against the rival that it leads least clearly.
Evidence lead(const Ranking& ranking, std::span<const TimedRow> rows, const std::string& mix) {
  std::optional<Evidence> least;
  const MedianInterval method = speedup_of(rows, mix, ranking.method);
  for (const std::string_view other : ranking.others) {
    const Evidence evidence =
        decided(mix, "speed over that of " + spoken_clipper(other),
                ratio(method, speedup_of(rows, mix, other)), "times", above(ranking.times_as_fast));
    if (!least || evidence.ends->low < least->ends->low) least = evidence;
  }
  return *least;
}

std::string confirmed_text(const Names& names, const Cases& cases) {
  return fmt::format("{} wins everywhere: it {} {} where it gains least.", names.method,
                     pace_text(cases.least()), names.rival);
}

// Beside two figures of the condition there is no room for another.
std::string conditional_text(const Names& names, const Cases& cases) {
  const std::string where = cases.where();
  if (figures_in(where).size() > 1) {
    const std::string best = cases.best();
    return where + (figures_in(best).empty() ? "; it gains most on " + best + "." : ".");
  }
  return fmt::format("{}; there {} {} {}.", where, names.method,
                     pace_text(cases.most_holding(), "up to "), names.rival);
}

std::string refuted_text(const Names& names, const Cases& cases, double published) {
  const double best = cases.most();
  const std::string pace = pace_text(best);
  if (best <= 1) {
    return fmt::format("{} wins nowhere: at its best it {} {}.", names.method, pace, names.rival);
  }
  if (published == 1) {
    return fmt::format("{} wins nowhere beyond the noise: at its best it {} {}.", names.method,
                       pace, names.rival);
  }
  return fmt::format("{} wins by less than published: at its best it {} {}.", names.method, pace,
                     names.rival);
}

}  // namespace

Judgement judge(const Ranking& ranking, const Results& results) {
  const std::vector<TimedRow> rows = timed_rows(ranking.field, results);
  const bool is_of_triangles = ranking.field == Field::triangles || ranking.field == Field::stage;
  Cases cases(is_of_triangles ? spoken_triangles : spoken_lines);
  for (const std::string& mix : distinct(rows, &TimedRow::mix)) {
    cases.add(lead(ranking, rows, mix));
  }
  if (cases.evidence().empty()) {
    throw MissingFigure(fmt::format("no table has a time of {}", ranking.method));
  }
  const Names names = spoken_names(ranking);
  return cases.judge({confirmed_text(names, cases), conditional_text(names, cases),
                      refuted_text(names, cases, ranking.times_as_fast)});
}

}  // namespace clipscope::experiments::claims

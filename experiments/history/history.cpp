// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "experiments/contestants/year.hpp"
#include "experiments/cost/rows.hpp"
#include "experiments/hard_cases/rows.hpp"
#include "experiments/history/rows.hpp"
#include "experiments/segments/literature.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/table/means.hpp"

namespace clipscope::experiments::history {
namespace {

using Figure = Row::Figure;

const std::string kFloat(kFormat<float>.name);

// What there is of a table; nothing of one that is not among the results.
template <class TableRow>
std::vector<TableRow> rows_if_any(const Results& results) {
  try {
    return results.rows<TableRow>();
  } catch (const MissingFigure&) {
    return {};
  }
}

// The rows of published methods that were timed in float.
template <class MixRow>
std::vector<MixRow> timed_rows(std::vector<MixRow> rows, const std::vector<Row>& published) {
  std::erase_if(rows, [&](const MixRow& r) {
    return r.scalar != kFloat || !r.timing ||
           find_row(published, &Row::clipper, r.clipper) == nullptr;
  });
  return rows;
}

template <class MixRow>
Figure fastest_on_percent(const std::vector<MixRow>& timed, const std::string& clipper) {
  std::map<std::string, const MixRow*> fastest;
  for (const MixRow& row : timed) {
    const MixRow*& best = fastest[row.mix];
    if (best == nullptr || row.timing->ns.median < best->timing->ns.median) best = &row;
  }
  if (fastest.empty()) return std::nullopt;
  const auto won = std::ranges::count_if(
      fastest, [&](const auto& mix) { return mix.second->clipper == clipper; });
  return 100.0 * static_cast<double>(won) / static_cast<double>(fastest.size());
}

// The mean of how many times faster than the usual method a clipper is, mix by mix.
template <class MixRow>
Figure mean_speedup(const std::vector<MixRow>& timed, const std::string& clipper,
                    std::string_view usual) {
  GeometricMean speedup;
  for (const MixRow& row : rows_where(timed, &MixRow::clipper, clipper)) {
    const MixRow* base = find_row(timed, &MixRow::mix, row.mix, &MixRow::clipper, usual);
    if (base == nullptr || !base->timing->speedup || !row.timing->speedup) continue;
    speedup.add(row.timing->speedup->median / base->timing->speedup->median);
  }
  return speedup.mean();
}

template <class MixRow>
void add_times(const std::vector<MixRow>& timed, std::string_view usual, Row& row) {
  GeometricMean ns;
  for (const MixRow& r : rows_where(timed, &MixRow::clipper, row.clipper)) {
    ns.add(r.timing->ns.median);
  }
  row.ns = ns.mean();
  row.speedup = mean_speedup(timed, row.clipper, usual);
  if (row.ns) row.fastest_on_percent = fastest_on_percent(timed, row.clipper);
}

Figure right_percent(const Figure& wrong_percent) {
  if (!wrong_percent) return std::nullopt;
  return 100 - *wrong_percent;
}

std::vector<Row> published(Field field) {
  const int vertices = field == Field::triangles ? 3 : 2;
  std::vector<Row> rows;
  for (const std::string_view clipper : clipper_names(vertices)) {
    const auto* full = find_in_contract(clipper, kFloat, Contract::full, vertices);
    const auto* plane = find_in_contract(clipper, kFloat, Contract::plane, vertices);
    const bool in_field = (field == Field::plane) == (plane != nullptr);
    if (full == nullptr || full->build != "scalar" || !in_field) continue;
    const std::optional<int> year = year_of(full->source);
    if (!year) continue;
    rows.push_back({.year = *year,
                    .clipper = std::string(clipper),
                    .idea = std::string(full->summary),
                    .field = field,
                    .source = std::string(full->source)});
  }
  return rows;
}

std::vector<Row> in_plane(const Results& results) {
  using R = segments::PlaneRow;
  std::vector<Row> rows = published(Field::plane);
  const auto all = rows_if_any<R>(results);
  const auto timed = timed_rows(all, rows);
  const auto hard = rows_if_any<segments::HardRow>(results);
  for (Row& row : rows) {
    add_times(timed, usual_method(Field::plane), row);
    const R* out =
        find_row(all, &R::mix, "both_ends_out", &R::clipper, row.clipper, &R::scalar, kFloat);
    if (out != nullptr) row.divisions = out->divisions;
    row.hard_right_percent =
        right_percent(segments::wrong_percent(hard, Contract::plane, row.clipper, kFloat));
  }
  return rows;
}

std::vector<Row> of_segments(const Results& results) {
  using R = segments::OperationsRow;
  std::vector<Row> rows = published(Field::segments);
  const auto timed = timed_rows(rows_if_any<segments::TimeRow>(results), rows);
  const auto operations = rows_if_any<R>(results);
  const auto hard = rows_if_any<segments::HardRow>(results);
  for (Row& row : rows) {
    add_times(timed, usual_method(Field::segments), row);
    const R* cut = find_row(operations, &R::mix, "cross_several", &R::clipper, row.clipper);
    if (cut != nullptr) row.divisions = cut->divisions_per_shortened;
    row.hard_right_percent =
        right_percent(segments::wrong_percent(hard, Contract::full, row.clipper, kFloat));
  }
  return rows;
}

Figure hard_triangles_right(const std::vector<hard_cases::SummaryRow>& summary,
                            const std::string& clipper) {
  using R = hard_cases::SummaryRow;
  const R* row = find_row(summary, &R::primitive, Primitive::triangle, &R::clipper, clipper,
                          &R::scalar, kFloat);
  if (row == nullptr || row->cases == 0) return std::nullopt;
  return 100.0 * static_cast<double>(row->cases - row->failures) / static_cast<double>(row->cases);
}

std::vector<Row> of_triangles(const Results& results) {
  using R = cost::OperationsRow;
  std::vector<Row> rows = published(Field::triangles);
  const auto timed = timed_rows(rows_if_any<cost::Row>(results), rows);
  const auto operations = rows_if_any<R>(results);
  const auto summary = rows_if_any<hard_cases::SummaryRow>(results);
  for (Row& row : rows) {
    add_times(timed, usual_method(Field::triangles), row);
    double divisions = 0;
    const auto counted = rows_where(operations, &R::clipper, row.clipper);
    for (const R& r : counted) divisions += r.divisions / static_cast<double>(counted.size());
    if (!counted.empty()) row.divisions = divisions;
    row.hard_right_percent = hard_triangles_right(summary, row.clipper);
  }
  return rows;
}

}  // namespace

std::string_view usual_method(Field field) {
  switch (field) {
    case Field::plane: return segments::kPlaneBaseline;
    case Field::segments: return "homogeneous/cohen_sutherland";
    default: return "homogeneous/sutherland_hodgman";
  }
}

std::vector<Row> history(const Results& results) {
  std::vector<Row> all;
  for (const auto& rows : {in_plane(results), of_segments(results), of_triangles(results)}) {
    all.insert(all.end(), rows.begin(), rows.end());
  }
  std::ranges::stable_sort(
      all, {}, [](const Row& row) { return std::tuple(row.year, row.field, row.clipper); });
  return all;
}

Plot history_plot(const std::vector<Row>& rows, Field field) {
  constexpr std::array kNames = {"history_plane", "history_segments", "history_triangles"};
  Plot plot{
      .name = kNames[static_cast<std::size_t>(field)],
      .title = fmt::format("Clipping of {}, by the year of the paper (float)", name_of(field)),
      .caption =
          "Each method once: its speed, where that of the usual method is 1, and the share of the hard cases that it gets right.",
      .x = {.label = "year"},
      .y = {.label = "speed; share right", .from = 0}};
  Series speed{.name = "speed", .marks = Marks::points};
  Series right{.name = "share of hard cases right", .marks = Marks::points};
  for (const Row& row : rows_where(rows, &Row::field, field)) {
    if (!row.speedup) continue;
    const auto year = static_cast<double>(row.year);
    speed.add(year, *row.speedup);
    speed.labels.push_back(row.clipper.substr(row.clipper.find('/') + 1));
    if (row.hard_right_percent) right.add(year, *row.hard_right_percent / 100);
  }
  if (!speed.x.empty()) plot.series = {speed, right};
  return plot;
}

}  // namespace clipscope::experiments::history

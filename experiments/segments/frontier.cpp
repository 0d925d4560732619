// SPDX-License-Identifier: GPL-3.0-or-later
//
// The frontier of the line clippers, from the tables alone.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "experiments/contestants/spoken.hpp"
#include "experiments/segments/literature.hpp"
#include "experiments/table/means.hpp"
#include "experiments/table/prose.hpp"

namespace clipscope::experiments::segments {
namespace {

std::string contestant_name(const SegmentFrontierRow& row) {
  return fmt::format("{} {}", row.clipper, row.scalar);
}

// The geometric mean of medians over the mixes, with that of their limits; none where it was not
// timed on one.
std::optional<MedianInterval> mean_time(const std::vector<TimeRow>& times,
                                        const std::string& clipper, const std::string& scalar) {
  GeometricMean median, low, high;
  for (const TimeRow& row :
       rows_where(times, &TimeRow::clipper, clipper, &TimeRow::scalar, scalar)) {
    if (!row.timing) return std::nullopt;
    median.add(row.timing->ns.median);
    low.add(row.timing->ns.low);
    high.add(row.timing->ns.high);
  }
  if (!median.mean()) return std::nullopt;
  return MedianInterval{*median.mean(), *low.mean(), *high.mean()};
}

void rank(std::vector<SegmentFrontierRow>& rows) {
  constexpr double kNever = std::numeric_limits<double>::quiet_NaN();
  std::vector<FrontierPoint> points;
  for (const SegmentFrontierRow& row : rows) {
    points.push_back(
        {row.ns.value_or(MedianInterval{kNever, kNever, kNever}), row.hard_wrong_percent});
  }
  const std::vector<FrontierRank> ranks = pareto_frontier(points);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& [standing, by] = ranks[i];
    rows[i].standing = standing;
    if (by) rows[i].dominated_by = contestant_name(rows[*by]);
  }
}

}  // namespace

std::optional<double> wrong_percent(const std::vector<HardRow>& hard, Contract contract,
                                    const std::string& clipper, const std::string& scalar) {
  std::int64_t segments = 0, wrong = 0;
  for (const HardRow& row : rows_where(hard, &HardRow::contract, contract, &HardRow::clipper,
                                       clipper, &HardRow::scalar, scalar)) {
    segments += row.segments;
    wrong += row.wrong;
  }
  if (segments == 0) return std::nullopt;
  return 100.0 * static_cast<double>(wrong) / static_cast<double>(segments);
}

std::vector<SegmentFrontierRow> segment_frontier(const std::vector<TimeRow>& times,
                                                 const std::vector<HardRow>& hard) {
  std::vector<SegmentFrontierRow> rows;
  for (const std::string& clipper : distinct(times, &TimeRow::clipper)) {
    for (const std::string& scalar : distinct(times, &TimeRow::scalar)) {
      const auto wrong = wrong_percent(hard, Contract::full, clipper, scalar);
      if (!wrong) continue;
      rows.push_back({.clipper = clipper,
                      .scalar = scalar,
                      .ns = mean_time(times, clipper, scalar),
                      .hard_wrong_percent = *wrong});
    }
  }
  rank(rows);
  std::ranges::stable_sort(rows, {}, [](const SegmentFrontierRow& row) {
    return row.ns ? row.ns->median : std::numeric_limits<double>::infinity();
  });
  return rows;
}

Plot frontier_plot(const std::vector<SegmentFrontierRow>& rows) {
  Plot plot{
      .name = "segments_frontier",
      .title = "Line clippers: time and wrong answers on hard cases",
      .caption =
          "Labelled: who is on the frontier. Time: geometric mean over the mixes, view space in, NDC out, four attributes.",
      .x = {.label = "time [ns/segment]", .logarithmic = true},
      .y = {.label = "hard cases wrong [%]", .from = 0}};
  for (const Standing standing : {Standing::frontier, Standing::dominated}) {
    const bool best = standing == Standing::frontier;
    Series series{.name = best ? "on the frontier" : "dominated", .marks = Marks::points};
    series.muted = !best;
    for (const SegmentFrontierRow& row : rows) {
      if (row.standing != standing) continue;
      series.add(row.ns->median, row.hard_wrong_percent);
      if (best) series.labels.push_back(contestant_name(row));
    }
    if (!series.x.empty()) plot.series.push_back(series);
  }
  return plot;
}

std::string frontier_finding(const std::vector<SegmentFrontierRow>& rows) {
  const std::vector<SegmentFrontierRow> on =
      rows_where(rows, &SegmentFrontierRow::standing, Standing::frontier);
  if (on.empty()) return "";
  const SegmentFrontierRow& best =
      *std::ranges::min_element(on, {}, &SegmentFrontierRow::hard_wrong_percent);
  const auto name = [](const SegmentFrontierRow& row) {
    return spoken_contestant(row.clipper, row.scalar);
  };
  const std::string right = best.hard_wrong_percent == 0 ? "always right" : "least often wrong";
  const std::string fastest = capitalised(name(on.front()));
  if (name(best) == name(on.front())) {
    return fmt::format(" {} is both the fastest from view space on and {} on hard segments.",
                       fastest, right);
  }
  return fmt::format(" From view space on {} is the fastest and {} {} on hard segments.",
                     name(on.front()), name(best), right);
}

}  // namespace clipscope::experiments::segments

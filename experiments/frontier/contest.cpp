// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/frontier/contest.hpp"

#include <limits>

namespace clipscope::experiments {
namespace {

void rank_by(ErrorMeasure measure, std::span<Entry> entries) {
  const std::vector<FrontierRank> ranks = pareto_frontier(frontier_points(entries, measure));
  for (std::size_t i = 0; i < entries.size(); ++i) {
    entries[i].ranks[static_cast<std::size_t>(measure)] = ranks[i];
  }
}

}  // namespace

std::string_view error_measure_name(ErrorMeasure measure) {
  switch (measure) {
    case ErrorMeasure::max_px: return "max_px";
    case ErrorMeasure::misrounded: return "misrounded";
    default: return "wrong";
  }
}

double Entry::error(ErrorMeasure measure) const {
  switch (measure) {
    case ErrorMeasure::max_px: return accuracy.error_px.max();
    case ErrorMeasure::misrounded: return 100.0 - accuracy.correctly_rounded_percent();
    default: return accuracy.wrong_percent();
  }
}

std::vector<FrontierPoint> frontier_points(std::span<const Entry> entries, ErrorMeasure measure) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::vector<FrontierPoint> points;
  for (const Entry& entry : entries) {
    const bool timed = entry.timing.refused.empty();
    points.push_back(
        {timed ? entry.timing.ns : MedianInterval{kNone, kNone, kNone}, entry.error(measure)});
  }
  return points;
}

std::vector<Entry> hold_contest(std::span<const TimedBatch> batches,
                                std::span<const AnyContestant> contestants,
                                const TimingOptions& options, Progress& progress) {
  const std::vector<BatchAccuracy> accuracies = judge_batches(batches, contestants, progress);
  const std::vector<Timing> timings = measure_time(batches, contestants, options);
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    entries.push_back({std::string(clipper_name(contestants[i])),
                       std::string(scalar_name(contestants[i])), timings[i], accuracies[i]});
  }
  for (const ErrorMeasure measure : kErrorMeasures) rank_by(measure, entries);
  return entries;
}

std::vector<std::size_t> steps_of(std::span<const Entry> entries, ErrorMeasure measure) {
  std::vector<FrontierRank> ranks;
  for (const Entry& entry : entries) ranks.push_back(entry.rank(measure));
  return frontier_steps(frontier_points(entries, measure), ranks);
}

}  // namespace clipscope::experiments

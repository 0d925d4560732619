// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/frontier/contest.hpp"

#include <algorithm>
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

std::vector<std::vector<Entry>> hold_stage_contest(
    const StageInput& input, const std::function<bool(std::string_view)>& is_selected,
    const StageTimingOptions& options) {
  StageContestants contestants = stage_contestants(input);
  contestants.erase(std::remove_if(contestants.begin() + 1, contestants.end(),
                                   [&](const auto& c) {
                                     return c->build() == "plain" || !is_selected(c->method());
                                   }),
                    contestants.end());
  Progress progress("frontier of the stage on " + input.name,
                    input.array_size() * contestants.size());
  const std::vector<BatchAccuracy> accuracies = judge_stage(input, contestants, progress);
  const StageMeasurement measured = measure_stage(input, contestants, options);
  std::vector<std::vector<Entry>> by_contract;
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    const StageTiming& t = measured.contestants[i];
    if (i == 0 && !is_selected(t.method)) continue;
    if (by_contract.empty() || by_contract.back().front().contract != t.contract) {
      by_contract.emplace_back();
    }
    by_contract.back().push_back({t.method, t.scalar, t.timing, accuracies[i], {}, t.contract});
  }
  for (std::vector<Entry>& entries : by_contract) {
    for (const ErrorMeasure measure : kErrorMeasures) rank_by(measure, entries);
  }
  return by_contract;
}

std::vector<std::size_t> steps_of(std::span<const Entry> entries, ErrorMeasure measure) {
  std::vector<FrontierRank> ranks;
  for (const Entry& entry : entries) ranks.push_back(entry.rank(measure));
  return frontier_steps(frontier_points(entries, measure), ranks);
}

}  // namespace clipscope::experiments

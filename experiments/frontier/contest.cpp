// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/frontier/contest.hpp"

#include <limits>

#include "experiments/selection/select.hpp"

namespace clipscope::experiments::frontier {
namespace {

// Those of one contract together, in their order.
std::vector<std::vector<Entry>> by_contract(const std::vector<Entry>& entries) {
  std::vector<std::vector<Entry>> contracts;
  for (const Entry& entry : entries) {
    const Contract contract = entry.contestant->contract;
    if (contracts.empty() || contracts.back().front().contestant->contract != contract) {
      contracts.emplace_back();
    }
    contracts.back().push_back(entry);
  }
  return contracts;
}

}  // namespace

double Entry::error(Measure measure) const {
  if (accuracy.visible == 0) return std::numeric_limits<double>::quiet_NaN();
  switch (measure) {
    case Measure::max_px: return accuracy.error_px.max();
    case Measure::misrounded: return 100.0 - accuracy.correctly_rounded_percent();
    default: return accuracy.wrong_percent();
  }
}

std::vector<FrontierPoint> frontier_points(std::span<const Entry> entries, Measure measure) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::vector<FrontierPoint> points;
  for (const Entry& entry : entries) {
    points.push_back(
        {entry.timing.is_timed() ? entry.timing.ns : MedianInterval{kNone, kNone, kNone},
         entry.error(measure)});
  }
  return points;
}

void rank(std::span<Entry> entries) {
  for (const Measure measure : kMeasures) {
    const std::vector<FrontierRank> ranks = pareto_frontier(frontier_points(entries, measure));
    for (std::size_t i = 0; i < entries.size(); ++i) {
      entries[i].ranks[static_cast<std::size_t>(measure)] = ranks[i];
    }
  }
}

std::vector<Entry> hold_contest(std::span<const SampledView> views, const Contestants& contestants,
                                const ContestClock& clock, Progress& progress) {
  const std::vector<BatchAccuracy> accuracies = judge_batches(views, contestants, progress);
  std::vector<Entry> entries;
  Inaccuracies inaccuracies;
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    const Entry& entry =
        entries.emplace_back(Entry{contestants[i], InputFrom::cache, {}, accuracies[i]});
    std::vector<double>& measured = inaccuracies.emplace_back();
    for (const Measure measure : kMeasures) measured.push_back(entry.error(measure));
  }
  const std::vector<Timing> timings = time_contestants(
      batches_of(views), contestants, find_contestant("textbook", "float"), clock, inaccuracies);
  for (std::size_t i = 0; i < entries.size(); ++i) entries[i].timing = timings[i];
  rank(entries);
  return entries;
}

std::vector<std::vector<Entry>> hold_stage_contest(const StageInput& soup,
                                                   const Contestants& selected, std::size_t timed,
                                                   const StageClock& clock) {
  Contestants contestants = stage_contestants(soup);
  const Contestant* baseline = contestants.front();
  std::erase_if(contestants, [&](const Contestant* c) {
    return c != baseline && (c->build == "plain" || !has_clipper(selected, c->clipper));
  });
  Progress progress("frontier of the stage on " + soup.name,
                    soup.array_size() * contestants.size());
  const std::vector<BatchAccuracy> accuracies = judge_stage(soup, contestants, progress);
  const StageInput copies = shuffled_copies(soup, timed, 1);
  std::vector<std::vector<Entry>> contests;
  for (const StageMeasurement& measured : measure_stage(copies, contestants, clock)) {
    std::vector<Entry> entries;
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      if (contestants[i] == baseline && !has_clipper(selected, baseline->clipper)) continue;
      entries.push_back(
          {contestants[i], measured.from, measured.contestants[i].timing, accuracies[i]});
    }
    for (std::vector<Entry>& contest : by_contract(entries)) contests.push_back(std::move(contest));
  }
  for (std::vector<Entry>& entries : contests) rank(entries);
  return contests;
}

std::vector<std::size_t> steps_of(std::span<const Entry> entries, Measure measure) {
  std::vector<FrontierRank> ranks;
  for (const Entry& entry : entries) ranks.push_back(entry.rank(measure));
  return frontier_steps(frontier_points(entries, measure), ranks);
}

}  // namespace clipscope::experiments::frontier

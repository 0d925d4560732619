// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/segments/judge.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

#include "experiments/measure/batches.hpp"
#include "experiments/report/replay_text.hpp"

namespace clipscope::experiments {
namespace {

constexpr int K = kSceneAttributes;

// Some segments of a view with their exact answers.
struct JudgedBatch {
  const View& view;
  std::vector<SceneSegment> segments;
  std::vector<TruthPolygon> truths;
};

JudgedBatch judged_batch(const SegmentBatch& batch, std::size_t sample) {
  JudgedBatch r{batch.view, {}, {}};
  for (const std::size_t i : evenly_spaced(batch.segments.size(), sample)) {
    r.segments.push_back(batch.segments[i]);
  }
  const auto truth = reference::Truth::of_frustum(frustum_cast<double>(batch.view.frustum));
  r.truths.resize(r.segments.size());
  tbb::parallel_for(std::size_t{0}, r.segments.size(), [&](std::size_t i) {
    r.truths[i] = truth_polygon(truth, input_segment(r.segments[i]), K);
  });
  return r;
}

void count(const Comparison& c, const JudgedBatch& batch, std::size_t i, SegmentTally& tally) {
  if (!c.visible) return;
  ++tally.outcomes[static_cast<std::size_t>(c.outcome)];
  if (is_failure(c.outcome) && c.outcome > tally.failing_outcome) {
    tally.failing_outcome = c.outcome;
    tally.failing = replay_text(batch.view, batch.segments[i]);
  }
  if (c.outcome > Outcome::visible) return;
  if (c.position_px > tally.max_px) {
    tally.max_px = c.position_px;
    tally.worst = replay_text(batch.view, batch.segments[i]);
  }
  tally.max_ulp = std::max(tally.max_ulp, c.position_ulp);
}

template <class T>
void judge(const Contestant<T, 2>& contestant, const JudgedBatch& batch, SegmentTally& tally) {
  PolygonStream<T, K> answers;
  contestant.view(projection_of<T>(batch.view), simplices_cast<T>(batch.segments), answers);
  std::vector<Comparison> comparisons(batch.segments.size());
  tbb::parallel_for(std::size_t{0}, comparisons.size(), [&](std::size_t i) {
    comparisons[i] = compare<T, K>(answers[i], batch.truths[i]);
  });
  for (std::size_t i = 0; i < comparisons.size(); ++i) count(comparisons[i], batch, i, tally);
}

}  // namespace

std::int64_t SegmentTally::visible() const {
  return std::accumulate(outcomes.begin(), outcomes.end(), std::int64_t{0});
}

std::int64_t SegmentTally::wrong() const {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (is_failure(static_cast<Outcome>(i))) sum += outcomes[i];
  }
  return sum;
}

std::string SegmentTally::wrong_kinds() const {
  std::string text;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (!is_failure(static_cast<Outcome>(i)) || outcomes[i] == 0) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", outcomes[i], kOutcomeNames[i]);
  }
  return text;
}

std::vector<SegmentTally> judge_segments(const SegmentMix& mix,
                                         std::span<const SegmentContestant> contestants,
                                         std::size_t sample) {
  std::vector<SegmentTally> tallies(contestants.size());
  for (const SegmentBatch& source : mix.batches) {
    const JudgedBatch batch = judged_batch(source, sample);
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      std::visit([&](const auto* c) { judge(*c, batch, tallies[i]); }, contestants[i]);
    }
  }
  return tallies;
}

std::string replay_text(const View& view, const SceneSegment& segment) {
  return fmt::format("--space view --primitive segment {} --depth {} --attributes {} : {}",
                     frustum_options(view.frustum), depth_option(view.frustum.depth), K,
                     hex_line(segment));
}

}  // namespace clipscope::experiments

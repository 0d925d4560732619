// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/survey/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "experiments/machine/errors.hpp"
#include "experiments/selection/replay_text.hpp"
#include "experiments/survey/judged_once.hpp"

namespace clipscope::experiments {

Outcome Tally::failing_outcome() const {
  for (std::size_t i = outcomes.size(); i-- > 0;) {
    const auto outcome = static_cast<Outcome>(i);
    if (outcomes[i] > 0 && is_failure(outcome)) return outcome;
  }
  return Outcome::exact;
}

void Tally::add(const Comparison& comparison, const std::function<std::string()>& replay) {
  ++primitives;
  if (!comparison.visible) return;
  if (is_failure(comparison.outcome)) {
    ++failures;
    if (comparison.outcome > failing_outcome()) failing = replay();
  }
  ++outcomes[static_cast<std::size_t>(comparison.outcome)];
  if (comparison.outcome > Outcome::visible) return;
  if (comparison.position_px > max_px) {
    max_px = comparison.position_px;
    worst = replay();
  }
  max_ulp = std::max(max_ulp, comparison.position_ulp);
  max_attribute = std::max(max_attribute, comparison.attribute);
  const auto bin = std::ranges::lower_bound(kUlpLimits, comparison.position_ulp);
  ++ulps[static_cast<std::size_t>(bin - kUlpLimits.begin())];
}

Tally& Tally::operator+=(const Tally& other) {
  if (other.failing_outcome() > failing_outcome() ||
      (other.failing_outcome() == failing_outcome() && other.failing_chunk < failing_chunk)) {
    failing = other.failing;
    failing_chunk = other.failing_chunk;
  }
  if (other.max_px > max_px || (other.max_px == max_px && other.worst_chunk < worst_chunk)) {
    max_px = other.max_px;
    worst = other.worst;
    worst_chunk = other.worst_chunk;
  }
  primitives += other.primitives;
  failures += other.failures;
  for (std::size_t i = 0; i < outcomes.size(); ++i) outcomes[i] += other.outcomes[i];
  max_ulp = std::max(max_ulp, other.max_ulp);
  max_attribute = std::max(max_attribute, other.max_attribute);
  for (std::size_t i = 0; i < ulps.size(); ++i) ulps[i] += other.ulps[i];
  rounding += other.rounding;
  return *this;
}

namespace {

reference::Truth truth_of(const SweepChunk& chunk) {
  if (!chunk.frustum) return reference::Truth::of_clip(chunk.volume);
  return reference::Truth::of_frustum(frustum_cast<double>(*chunk.frustum), chunk.volume);
}

// What is said of one answer.
struct SweepJudgement {
  Comparison comparison;
  RoundingCount rounding;
};

std::vector<Tally> sweep_one(const SweepChunk& chunk, std::size_t number,
                             const Contestants& contestants) {
  const reference::Truth truth = truth_of(chunk);
  const Batch batch = chunk.batch();
  std::vector<std::pair<std::size_t, Answers>> answers;  // with the contestant's place
  for (std::size_t c = 0; c < contestants.size(); ++c) {
    if (contestants[c]->takes(batch)) answers.emplace_back(c, clip(*contestants[c], batch));
  }
  std::vector<Tally> tallies(contestants.size());
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const TruthPolygon exact = truth_polygon(truth, input_vertices(batch, i), batch.attributes);
    NearestPolygon nearest(exact);
    JudgedOnce<SweepJudgement> judgements;
    for (const auto& [c, answer] : answers) {
      const PolygonView polygon = answer[i];
      const SweepJudgement judgement = judgements.of(polygon, [&] {
        return SweepJudgement{compare(polygon, exact), nearest.count(polygon)};
      });
      tallies[c].add(judgement.comparison, [&] { return replay_text(chunk, i); });
      tallies[c].rounding += judgement.rounding;
    }
  }
  for (Tally& tally : tallies) {
    if (!tally.worst.empty()) tally.worst_chunk = static_cast<std::int64_t>(number);
    if (!tally.failing.empty()) tally.failing_chunk = static_cast<std::int64_t>(number);
  }
  return tallies;
}

void check_scalars(const Contestants& contestants) {
  for (const Contestant* c : contestants) {
    if (c->format != &kFormat<float> && c->format != &kFormat<double>) {
      throw UsageError(
          fmt::format("--scalar: a sweep takes float and double, '{}' was given", c->scalar()));
    }
  }
}

}  // namespace

Batch SweepChunk::batch() const {
  Batch batch = frustum ? batch_of(*frustum, std::span(view)) : batch_of(volume, std::span(clip));
  batch.volume = volume;
  return batch;
}

std::string replay_text(const SweepChunk& chunk, std::size_t triangle) {
  return replay_text(chunk.batch(), triangle);
}

std::vector<Tally> sweep(const SweepSource& source, ChunkNumbers chunks,
                         const Contestants& contestants, Progress& progress) {
  check_scalars(contestants);
  std::vector<Tally> total(contestants.size());
  work_in_order(
      chunks.size(), kChunksAtOnce, progress,
      [&](std::size_t i) { return sweep_one(source.chunk(chunks[i]), chunks[i], contestants); },
      [&](const std::vector<Tally>& part) {
        for (std::size_t c = 0; c < total.size(); ++c) total[c] += part[c];
      });
  return total;
}

std::vector<Tally> sweep(const SweepSource& source, const Contestants& contestants,
                         Progress& progress) {
  std::vector<std::size_t> all(source.chunks);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return sweep(source, all, contestants, progress);
}

}  // namespace clipscope::experiments

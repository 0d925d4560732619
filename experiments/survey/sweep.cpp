// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/survey/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "experiments/machine/errors.hpp"
#include "experiments/selection/replay_text.hpp"
#include "experiments/survey/judged_once.hpp"

namespace clipscope::experiments {

void Tally::add(const Comparison& comparison, const std::function<std::string()>& replay) {
  ++primitives;
  if (!comparison.visible) return;
  ++outcomes[static_cast<std::size_t>(comparison.outcome)];
  if (is_failure(comparison.outcome)) {
    ++failures;
    if (comparison.outcome > failing_outcome) {
      failing_outcome = comparison.outcome;
      failing = replay();
    }
  }
  if (comparison.outcome > Outcome::visible) return;
  if (comparison.position_px > max_px) {
    max_px = comparison.position_px;
    worst = replay();
  }
  max_ulp = std::max(max_ulp, comparison.position_ulp);
  max_attribute = std::max(max_attribute, comparison.attribute);
}

Tally& Tally::operator+=(const Tally& other) {
  for (std::size_t i = 0; i < outcomes.size(); ++i) outcomes[i] += other.outcomes[i];
  primitives += other.primitives;
  failures += other.failures;
  if (other.failing_outcome > failing_outcome) {
    failing_outcome = other.failing_outcome;
    failing = other.failing;
  }
  if (other.max_px > max_px) {
    max_px = other.max_px;
    worst = other.worst;
  }
  max_ulp = std::max(max_ulp, other.max_ulp);
  max_attribute = std::max(max_attribute, other.max_attribute);
  return *this;
}

namespace {

constexpr std::size_t kWindow = 64;  // chunks in work at once

reference::Truth truth_of(const SweepChunk& chunk) {
  if (!chunk.frustum) return reference::Truth::of_clip(chunk.volume);
  return reference::Truth::of_frustum(frustum_cast<double>(*chunk.frustum), chunk.volume);
}

std::vector<Tally> sweep_one(const SweepChunk& chunk, const Contestants& contestants) {
  const reference::Truth truth = truth_of(chunk);
  const Batch batch = chunk.batch();
  std::vector<std::pair<std::size_t, Answers>> answers;  // with the contestant's place
  for (std::size_t c = 0; c < contestants.size(); ++c) {
    if (contestants[c]->takes(batch)) answers.emplace_back(c, clip(*contestants[c], batch));
  }
  std::vector<Tally> tallies(contestants.size());
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const TruthPolygon exact = truth_polygon(truth, input_vertices(batch, i), batch.attributes);
    JudgedOnce<Comparison> comparisons;
    for (const auto& [c, answer] : answers) {
      const PolygonView polygon = answer[i];
      tallies[c].add(comparisons.of(polygon, [&] { return compare(polygon, exact); }),
                     [&] { return replay_text(chunk, i); });
    }
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

std::vector<Tally> sweep(std::size_t chunks,
                         const std::function<SweepChunk(std::size_t)>& make_chunk,
                         const Contestants& contestants, Progress& progress) {
  check_scalars(contestants);
  std::vector<Tally> total(contestants.size());
  work_in_order(
      chunks, kWindow, progress,
      [&](std::size_t i) { return sweep_one(make_chunk(i), contestants); },
      [&](const std::vector<Tally>& part) {
        for (std::size_t c = 0; c < total.size(); ++c) total[c] += part[c];
      });
  return total;
}

}  // namespace clipscope::experiments

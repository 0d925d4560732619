// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/measure/sweep.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "experiments/errors.hpp"
#include "experiments/measure/batches.hpp"
#include "experiments/report/replay_text.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kWindow = 64;  // chunks in work at once

constexpr int K = kSceneAttributes;

template <class T>
bool same_bits(std::span<const NdcVertex<T, K>> a, std::span<const NdcVertex<T, K>> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& u, const auto& v) {
    return u.position == v.position && u.attributes.values == v.attributes.values;
  });
}

// The contestants in T, by their place in the list of all.
template <class T>
std::vector<std::pair<std::size_t, const Contestant<T>*>> contestants_in(
    const std::vector<AnyContestant>& all) {
  std::vector<std::pair<std::size_t, const Contestant<T>*>> r;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (const auto* c = std::get_if<const Contestant<T>*>(&all[i])) r.emplace_back(i, *c);
  }
  return r;
}

reference::Truth truth_of(const SweepChunk& chunk) {
  if (!chunk.frustum) return reference::Truth::of_clip(chunk.volume);
  return reference::Truth::of_frustum(frustum_cast<double>(*chunk.frustum), chunk.volume);
}

reference::InputTriangle input_of(const SweepChunk& chunk, std::size_t i) {
  return chunk.frustum ? reference::input_triangle(chunk.view[i])
                       : reference::input_triangle(chunk.clip[i]);
}

void count(const Comparison& comparison, const SweepChunk& chunk, std::size_t triangle,
           SweepTally& tally) {
  ++tally.triangles;
  if (!comparison.visible) return;
  ++tally.outcomes[static_cast<std::size_t>(comparison.outcome)];
  if (is_failure(comparison.outcome)) {
    ++tally.failures;
    if (comparison.outcome > tally.failing_outcome) {
      tally.failing_outcome = comparison.outcome;
      tally.failing = replay_text(chunk, triangle);
    }
  }
  if (comparison.outcome > Outcome::visible) return;
  if (comparison.position_px > tally.max_px) {
    tally.max_px = comparison.position_px;
    tally.worst = replay_text(chunk, triangle);
  }
  tally.max_ulp = std::max(tally.max_ulp, comparison.position_ulp);
  tally.max_attribute = std::max(tally.max_attribute, comparison.attribute);
}

// Clips a chunk by all contestants in T and judges the answers. Many methods give the same bits for
// most triangles: each different answer is compared once.
template <class T>
void sweep_chunk(const SweepChunk& chunk, const std::vector<TruthPolygon>& truths,
                 const std::vector<AnyContestant>& all, std::vector<SweepTally>& tallies) {
  const auto contestants = contestants_in<T>(all);
  std::vector<std::pair<std::size_t, PolygonStream<T, K>>> answers;
  for (const auto& [index, contestant] : contestants) {
    if (!is_applicable(contestant->promise, chunk.volume)) continue;
    PolygonStream<T, K> stream;
    if (chunk.frustum) {
      Projection<T> projection(frustum_cast<T>(*chunk.frustum));
      projection.volume = chunk.volume;
      contestant->view(projection, simplices_cast<T>(chunk.view), stream);
    } else if (contestant->clip != nullptr) {
      contestant->clip(chunk.volume, simplices_cast<T>(chunk.clip), stream);
    } else {
      continue;
    }
    answers.emplace_back(index, std::move(stream));
  }
  for (std::size_t i = 0; i < chunk.size(); ++i) {
    std::vector<std::pair<std::span<const NdcVertex<T, K>>, Comparison>> judged;
    for (const auto& [index, stream] : answers) {
      const auto polygon = stream[i];
      auto known = std::find_if(judged.begin(), judged.end(),
                                [&](const auto& j) { return same_bits<T>(j.first, polygon); });
      if (known == judged.end()) {
        judged.emplace_back(polygon, compare<T, K>(polygon, truths[i]));
        known = judged.end() - 1;
      }
      count(known->second, chunk, i, tallies[index]);
    }
  }
}

std::vector<SweepTally> sweep_one(const SweepChunk& chunk,
                                  const std::vector<AnyContestant>& contestants) {
  const reference::Truth truth = truth_of(chunk);
  std::vector<TruthPolygon> truths;
  truths.reserve(chunk.size());
  for (std::size_t i = 0; i < chunk.size(); ++i) {
    truths.push_back(truth_polygon(truth, input_of(chunk, i)));
  }
  std::vector<SweepTally> tallies(contestants.size());
  sweep_chunk<float>(chunk, truths, contestants, tallies);
  sweep_chunk<double>(chunk, truths, contestants, tallies);
  return tallies;
}

void merge(const SweepTally& part, SweepTally& whole) {
  for (std::size_t i = 0; i < part.outcomes.size(); ++i) whole.outcomes[i] += part.outcomes[i];
  whole.triangles += part.triangles;
  whole.failures += part.failures;
  if (part.failing_outcome > whole.failing_outcome) {
    whole.failing_outcome = part.failing_outcome;
    whole.failing = part.failing;
  }
  if (part.max_px > whole.max_px) {
    whole.max_px = part.max_px;
    whole.worst = part.worst;
  }
  whole.max_ulp = std::max(whole.max_ulp, part.max_ulp);
  whole.max_attribute = std::max(whole.max_attribute, part.max_attribute);
}

void check_scalars(const std::vector<AnyContestant>& contestants) {
  for (const AnyContestant& c : contestants) {
    const std::string_view scalar = scalar_name(c);
    if (scalar != ScalarTraits<float>::name && scalar != ScalarTraits<double>::name) {
      throw UsageError(
          fmt::format("--scalar: a sweep takes float and double, '{}' was given", scalar));
    }
  }
}

}  // namespace

std::string replay_text(const SweepChunk& chunk, std::size_t triangle) {
  const reference::InputTriangle input = input_of(chunk, triangle);
  const std::string space =
      chunk.frustum ? "--space view " + frustum_options(*chunk.frustum) : "--space clip";
  return fmt::format("{} --depth {} --attributes {} : {}", space, depth_option(chunk.volume.depth),
                     input.attribute_count,
                     hex_line(input.vertices, chunk.frustum ? 3 : 4, input.attribute_count));
}

std::vector<SweepTally> sweep(std::size_t chunks,
                              const std::function<SweepChunk(std::size_t)>& make_chunk,
                              const std::vector<AnyContestant>& contestants, Progress& progress) {
  check_scalars(contestants);
  std::vector<SweepTally> total(contestants.size());
  for (std::size_t first = 0; first < chunks; first += kWindow) {
    const std::size_t count = std::min(kWindow, chunks - first);
    std::vector<std::vector<SweepTally>> parts(count);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
      parts[i] = sweep_one(make_chunk(first + i), contestants);
    });
    for (const std::vector<SweepTally>& part : parts) {
      for (std::size_t c = 0; c < total.size(); ++c) merge(part[c], total[c]);
    }
    progress.advance(count);
  }
  return total;
}

}  // namespace clipscope::experiments

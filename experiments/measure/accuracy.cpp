// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/measure/accuracy.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

#include "experiments/measure/batches.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kChunk = 2048;  // triangles

// A chunk of one view with its exact answers.
struct Chunk {
  const Scene& scene;
  const View& view;
  Sample sample;
  std::size_t first;
  std::vector<SceneTriangle> triangles;
  std::vector<TruthPolygon> truths;
};

reference::Truth truth_of(const View& view, reference::TruthKind kind) {
  if (kind == reference::TruthKind::matrix) {
    return reference::Truth::of_matrix(projection_of<float>(view));
  }
  return reference::Truth::of_frustum(frustum_cast<double>(view.frustum));
}

template <class T>
void judge_chunk(const Contestant<T>& contestant, const Chunk& chunk, AccuracyTally& tally) {
  const auto triangles = simplices_cast<T>(chunk.triangles);
  PolygonStream<T, kSceneAttributes> polygons;
  contestant.view(projection_of<T>(chunk.view), triangles, polygons);

  std::vector<Comparison> comparisons(triangles.size());
  tbb::parallel_for(std::size_t{0}, triangles.size(), [&](std::size_t i) {
    comparisons[i] = compare<T, kSceneAttributes>(polygons[i], chunk.truths[i]);
  });

  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    const Comparison& c = comparisons[i];
    ++tally.triangles;
    if (!c.visible) continue;
    ++tally.outcomes[static_cast<std::size_t>(c.outcome)];
    if (c.outcome > Outcome::visible) continue;
    tally.position_px.add(c.position_px);
    tally.position_ulp.add(c.position_ulp);
    tally.attribute.add(c.attribute);
    if (c.position_px > tally.worst_position.error) {
      tally.worst_position = {c.position_px, chunk.scene.name, chunk.view.label,
                              (chunk.first + i) * chunk.sample.stride};
    }
  }
}

}  // namespace

std::int64_t AccuracyTally::visible() const {
  return std::accumulate(outcomes.begin(), outcomes.end(), std::int64_t{0});
}

std::size_t sampled_triangles(const Scene& scene, const AccuracyOptions& options) {
  return sample_of(scene, options.triangles_per_view).count * scene.views.size();
}

void measure_accuracy(const Scene& scene, std::span<const AnyContestant> contestants,
                      const AccuracyOptions& options, std::span<AccuracyTally> tallies,
                      Progress& progress) {
  const Sample sample = sample_of(scene, options.triangles_per_view);
  for (const View& view : scene.views) {
    const reference::Truth truth = truth_of(view, options.truth);
    for (std::size_t first = 0; first < sample.count; first += kChunk) {
      const std::size_t count = std::min(kChunk, sample.count - first);
      Chunk chunk{scene,
                  view,
                  sample,
                  first,
                  sampled_view_triangles(scene, view, sample, first, count),
                  std::vector<TruthPolygon>(count)};
      tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        chunk.truths[i] = truth_polygon(truth, reference::input_triangle(chunk.triangles[i]));
      });
      for (std::size_t c = 0; c < contestants.size(); ++c) {
        std::visit([&](const auto* contestant) { judge_chunk(*contestant, chunk, tallies[c]); },
                   contestants[c]);
      }
      progress.advance(count);
    }
  }
}

}  // namespace clipscope::experiments

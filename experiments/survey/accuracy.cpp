// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/survey/accuracy.hpp"

#include <algorithm>

#include "experiments/judge/containment.hpp"

namespace clipscope::experiments {
namespace {

reference::Truth truth_of(const View& view, reference::TruthKind kind) {
  if (kind == reference::TruthKind::matrix && !view.matrix) {
    return reference::Truth::of_matrix(Projection<float>(view.frustum));
  }
  return experiments::truth_of(view);
}

// Whether the triangle has the largest error so far.
bool add(const Comparison& c, AccuracyTally& tally) {
  ++tally.triangles;
  if (!c.visible) return false;
  ++tally.outcomes[static_cast<std::size_t>(c.outcome)];
  if (c.outcome > Outcome::visible) return false;
  tally.position_px.add(c.position_px);
  tally.position_ulp.add(c.position_ulp);
  tally.attribute.add(c.attribute);
  return c.position_px > tally.worst_position.error;
}

}  // namespace

std::size_t sampled_triangles(const Scene& scene, const AccuracyOptions& options) {
  return spacing_of(scene, options.triangles_per_view).count * scene.views.size();
}

void measure_accuracy(const Scene& scene, const Contestants& contestants,
                      const AccuracyOptions& options, std::span<AccuracyTally> tallies,
                      Progress& progress) {
  const Spacing spacing = spacing_of(scene, options.triangles_per_view);
  for (const View& view : scene.views) {
    const reference::Truth truth = truth_of(view, options.truth);
    const auto judge_chunk = [&](std::span<const SceneTriangle> triangles, std::size_t first) {
      const Batch batch = batch_of(view, triangles);
      const std::vector<TruthPolygon> truths = truth_polygons(truth, batch);
      for (std::size_t c = 0; c < contestants.size(); ++c) {
        const Answers answers = clip(*contestants[c], batch);
        const auto comparisons = compare(answers, truths);
        for (std::size_t i = 0; i < comparisons.size(); ++i) {
          tallies[c].overshoot =
              std::max(tallies[c].overshoot, overshoot(batch.volume, answers[i]));
          if (!add(comparisons[i], tallies[c])) continue;
          tallies[c].worst_position = {comparisons[i].position_px, scene.name, view.label,
                                       (first + i) * spacing.stride};
        }
      }
      progress.advance(triangles.size());
    };
    for_each_chunk(scene, view, spacing, judge_chunk);
  }
}

}  // namespace clipscope::experiments

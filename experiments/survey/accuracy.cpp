// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/survey/accuracy.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "experiments/judge/containment.hpp"
#include "experiments/survey/judged_once.hpp"

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

// Who is judged on the same numbers, and what is known of each.
struct Judged {
  Contestants contestants;
  std::vector<AccuracyTally*> tallies;
};

struct Finding {
  Comparison comparison;
  double overshoot = 0;
};

// Of one triangle, contestant by contestant.
std::vector<Finding> findings(const ClipVolume& volume, const TruthPolygon& truth,
                              std::span<const Answers> answers, std::size_t triangle) {
  std::vector<Finding> found;
  JudgedOnce<Finding> known;
  for (const Answers& answer : answers) {
    const PolygonView polygon = answer[triangle];
    found.push_back(known.of(polygon, [&] {
      return Finding{compare(polygon, truth), overshoot(volume, polygon)};
    }));
  }
  return found;
}

// A view with its truth; triangle i of the sample is triangle i * stride of the mesh.
struct Exhibit {
  const Scene& scene;
  const View& view;
  reference::Truth truth;
  std::size_t stride;
};

// first: the number of the batch's first triangle in the sample.
void judge(const Exhibit& exhibit, const Batch& batch, std::size_t first, const Judged& judged) {
  if (judged.contestants.empty()) return;
  const std::vector<TruthPolygon> truths = truth_polygons(exhibit.truth, batch);
  const std::vector<Answers> answers = answers_of(judged.contestants, batch);
  std::vector<std::vector<Finding>> found(truths.size());
  tbb::parallel_for(std::size_t{0}, truths.size(), [&](std::size_t i) {
    found[i] = findings(batch.volume, truths[i], answers, i);
  });
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (std::size_t c = 0; c < found[i].size(); ++c) {
      AccuracyTally& tally = *judged.tallies[c];
      const auto& [comparison, overshoot] = found[i][c];
      tally.overshoot = std::max(tally.overshoot, overshoot);
      if (!add(comparison, tally)) continue;
      tally.worst_position = {comparison.position_px, exhibit.scene.name, exhibit.view.label,
                              (first + i) * exhibit.stride};
    }
  }
}

}  // namespace

std::size_t sampled_triangles(const Scene& scene, const AccuracyOptions& options) {
  return spacing_of(scene, options.triangles_per_view).count * scene.views.size();
}

void measure_accuracy(const Scene& scene, const Contestants& contestants,
                      const AccuracyOptions& options, std::span<AccuracyTally> tallies,
                      Progress& progress) {
  Judged in_float, in_double;
  for (std::size_t c = 0; c < contestants.size(); ++c) {
    const bool doubles = options.in_double && takes_doubles(*contestants[c]->format, scene);
    Judged& judged = doubles ? in_double : in_float;
    judged.contestants.push_back(contestants[c]);
    judged.tallies.push_back(&tallies[c]);
  }
  const Spacing spacing = spacing_of(scene, options.triangles_per_view);
  for (const View& view : scene.views) {
    const Exhibit exhibit{scene, view, truth_of(view, options.truth), spacing.stride};
    for_each_chunk(scene, view, spacing, [&](const auto& triangles, std::size_t first) {
      judge(exhibit, batch_of(view, triangles), first, in_float);
      if (!in_double.contestants.empty()) {
        const auto as_given = sampled_view_triangles<DoubleSceneTriangle>(scene, view, spacing,
                                                                          first, triangles.size());
        judge(exhibit, batch_of(view, as_given), first, in_double);
      }
      progress.advance(triangles.size());
    });
  }
}

}  // namespace clipscope::experiments

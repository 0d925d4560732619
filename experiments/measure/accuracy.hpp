// SPDX-License-Identifier: GPL-3.0-or-later
//
// Accuracy of clippers on a scene: every triangle of every view against the exact reference.
//
// The mesh is streamed in chunks; memory does not grow with the number of triangles. Triangles of a
// chunk are judged in parallel and tallied in order, so that the result does not depend on the
// number of threads.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "experiments/measure/compare.hpp"
#include "experiments/measure/statistics.hpp"
#include "experiments/report/progress.hpp"
#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

// The triangle that a largest error was found on.
struct Worst {
  double error = 0;
  std::string scene, view;
  std::size_t triangle = 0;  // its number in the mesh
};

struct AccuracyTally {
  std::array<std::int64_t, kOutcomes> outcomes{};  // of triangles visible in truth or in the answer
  std::int64_t triangles = 0;                      // all of them
  LogHistogram position_px, position_ulp, attribute;
  Worst worst_position;

  std::int64_t count(Outcome o) const { return outcomes[static_cast<std::size_t>(o)]; }
  std::int64_t visible() const;
};

struct AccuracyOptions {
  reference::TruthKind truth = reference::TruthKind::frustum;
  std::size_t triangles_per_view = 0;  // evenly spaced over the mesh; 0: all
};

// The number of triangles that measure_accuracy will go through.
std::size_t sampled_triangles(const Scene& scene, const AccuracyOptions& options);

// Adds to tallies[i] what contestants[i] does on the scene; advances progress by sampled triangles.
void measure_accuracy(const Scene& scene, std::span<const AnyContestant> contestants,
                      const AccuracyOptions& options, std::span<AccuracyTally> tallies,
                      Progress& progress);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Timing that can be believed.
//
// Inputs are prepared before. Answers are checked against the contestant's promise first: one that
// breaks it is not timed. Then the contestants run in turn, round after round, in an order that
// rotates, each once per round on the same triangles; a slow one on the same leading share of each
// view. Of the rounds come the median time per triangle with its 95 % interval and, round by round,
// the ratio to the baseline run in that same round, so that a drift of the machine's speed
// cancels. The thread is pinned to one processor where that is allowed; threads that helped to check
// are not.
// Timed is the contract's whole way: view space in, NDC polygons out, written one after the other.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "experiments/measure/statistics.hpp"
#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

// Triangles of one view, all of which every contestant clips.
struct TimedBatch {
  View view;
  std::vector<SceneTriangle> triangles;
  std::vector<std::size_t> numbers = {};  // in the mesh, one per triangle; empty if there is none
};

struct TimingOptions {
  int rounds = 25;
  double milliseconds_per_run = 2.0;    // a contestant's share of a round; at least kLeastTriangles
  std::size_t checked_triangles = 256;  // of each batch set, in parallel, before anything is timed
};

// ns per triangle, and how many times faster than the baseline (above 1: faster).
struct Timing {
  MedianInterval ns;
  MedianInterval speedup;
  std::vector<double> samples_ns;  // one per round
  std::string refused;             // why it was not timed; then the rest is empty
};

// The baseline that ratios refer to: textbook in float.
AnyContestant baseline();

// One timing per contestant, in their order. The baseline is run whether it is among them or not.
std::vector<Timing> measure_time(std::span<const TimedBatch> batches,
                                 std::span<const AnyContestant> contestants,
                                 const TimingOptions& options);

// Runs the tasks in turn, round after round, each once per round, in an order that rotates, on a thread
// that is pinned where that is allowed. A task returns what it measured, in ns per triangle.
// Returns samples[task][round]: those of one round belong together.
std::vector<std::vector<double>> run_in_turn(std::span<const std::function<double()>> tasks,
                                             int rounds);

// Round by round, one sample over the other. Pre-condition: as many in both.
std::vector<double> ratios(std::span<const double> numerators,
                           std::span<const double> denominators);

// Up to `limit` triangles of the scene's views, evenly spaced and shuffled with a fixed seed, so
// that a leading share of a batch is like the whole.
std::vector<TimedBatch> timed_batches(const Scene& scene, std::size_t limit);

}  // namespace clipscope::experiments

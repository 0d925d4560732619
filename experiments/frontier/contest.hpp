// SPDX-License-Identifier: GPL-3.0-or-later
//
// One set of triangles: every contestant's time and errors on the same triangles in the same run, and
// who is on the frontier by each measure of error. Each contract has a frontier of its own: full, and of the
// stage copy and reference.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/measure/batch_accuracy.hpp"
#include "experiments/measure/pareto.hpp"
#include "experiments/measure/stage_timing.hpp"
#include "experiments/measure/timing.hpp"

namespace clipscope::experiments {

// Errors, each 0 where nothing is wrong; units px and percent (experiments/measure/batch_accuracy.hpp).
enum class ErrorMeasure {
  max_px,      // the largest distance on screen over all visible triangles, wrong ones included
  misrounded,  // coordinates that are not the nearest floats
  wrong        // triangles with the wrong vertices
};
inline constexpr std::array kErrorMeasures = {ErrorMeasure::max_px, ErrorMeasure::misrounded,
                                              ErrorMeasure::wrong};
std::string_view error_measure_name(ErrorMeasure measure);  // "max_px" and so on

struct Entry {
  std::string clipper, scalar;
  Timing timing;
  BatchAccuracy accuracy;
  std::array<FrontierRank, kErrorMeasures.size()> ranks = {};  // by measure, within the contract
  std::string contract = "full";

  double error(ErrorMeasure measure) const;
  const FrontierRank& rank(ErrorMeasure measure) const {
    return ranks[static_cast<std::size_t>(measure)];
  }
};

// A time and an error each. One that was not timed has a NaN for a time: it is unranked.
std::vector<FrontierPoint> frontier_points(std::span<const Entry> entries, ErrorMeasure measure);

// Judges all contestants on all triangles of the batches, then times them on the same, slow ones on a
// leading share of each batch.
std::vector<Entry> hold_contest(std::span<const TimedBatch> batches,
                                std::span<const AnyContestant> contestants,
                                const TimingOptions& options, Progress& progress);

// The stage's: judges and times those whose clipper `is_selected`, in SIMD, on all triangles of the input. Those of
// one contract are together.
std::vector<std::vector<Entry>> hold_stage_contest(
    const StageInput& input, const std::function<bool(std::string_view)>& is_selected,
    const StageTimingOptions& options);

// Indices of the frontier's members by the measure, from the fastest on, each with a smaller error.
std::vector<std::size_t> steps_of(std::span<const Entry> entries, ErrorMeasure measure);

}  // namespace clipscope::experiments

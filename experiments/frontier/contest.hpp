// SPDX-License-Identifier: GPL-3.0-or-later
//
// One set of triangles: every contestant's time and errors on the same triangles in the same run,
// and who is on the frontier by each measure of error. Each contract has a frontier of its own:
// full, and of the stage copy and number, from memory and from cache.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "experiments/stage/stage_timing.hpp"
#include "experiments/survey/batch_accuracy.hpp"
#include "experiments/survey/contest_clock.hpp"
#include "experiments/survey/pareto.hpp"

namespace clipscope::experiments::frontier {

// Errors, each 0 where nothing is wrong; units px and percent (survey/batch_accuracy.hpp).
enum class Measure {
  max_px,      // the largest distance on screen over all visible triangles, wrong ones included
  misrounded,  // coordinates that are not the nearest floats
  wrong        // triangles with the wrong vertices
};
inline constexpr std::array kMeasures = {Measure::max_px, Measure::misrounded, Measure::wrong};
constexpr std::array<std::string_view, 3> names_of(Measure) {
  return {"max_px", "misrounded", "wrong"};
}

struct Entry {
  const Contestant* contestant = nullptr;
  InputFrom from = InputFrom::cache;  // when timed
  Timing timing = {};
  BatchAccuracy accuracy = {};
  std::array<FrontierRank, kMeasures.size()> ranks = {};  // by measure, among those beside it

  double error(Measure measure) const;
  const FrontierRank& rank(Measure measure) const {
    return ranks[static_cast<std::size_t>(measure)];
  }
};

// A time and an error each. One that was not timed has a NaN for a time: it is unranked.
std::vector<FrontierPoint> frontier_points(std::span<const Entry> entries, Measure measure);

// Ranks the entries by every measure.
void rank(std::span<Entry> entries);

// Judges all contestants on all triangles of the views, then times them on the same, slow ones on a
// leading share of each view; the triangles come again and again, and stay in cache.
std::vector<Entry> hold_contest(std::span<const SampledView> views, const Contestants& contestants,
                                const ContestClock& clock, Progress& progress);

// The stage's: judges those whose clipper is selected, in SIMD, on all triangles of the soup, and
// times them on at least `timed` triangles, the soup's again and again in other orders, so that no
// cache holds them and no branch predictor knows them. Those of one contract from one place are
// together.
std::vector<std::vector<Entry>> hold_stage_contest(const StageInput& soup,
                                                   const Contestants& selected, std::size_t timed,
                                                   const StageClock& clock);

// Indices of the frontier's members by the measure, from the fastest on, each with a smaller error.
std::vector<std::size_t> steps_of(std::span<const Entry> entries, Measure measure);

}  // namespace clipscope::experiments::frontier

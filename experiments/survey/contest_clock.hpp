// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contestants under the clock: each clips the same primitives, in its own scalar, from input that
// was prepared before.
//
// Timed is the contract's whole way: view space in, NDC polygons out, written one after the other.
// A slow contestant takes the same leading share of each batch in all rounds. Everything is warm on
// purpose: all clip the same primitives again and again, so that what is compared is arithmetic and
// branches, not memory. What streams from memory is stage/stage_timing.hpp's.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "experiments/clock/clock.hpp"
#include "experiments/contestants/contestant.hpp"

namespace clipscope::experiments {

struct ContestClock {
  int rounds = 25;
  double milliseconds_per_run = 2.0;  // a contestant's part of a round; at least some primitives
  std::size_t checked = 256;          // primitives of all batches whose answers are checked
  double far = 10;                    // see ClockOptions
};

// The clock of experiments: quick, or for figures.
ContestClock contest_clock(bool quick);

// Clips the batches, which outlive it. Checked is the contestant's promise.
Task contest_task(const Contestant& contestant, std::span<const Batch> batches,
                  std::size_t checked);

// How inaccurate each contestant is, in measures of which smaller is better; see Task. Empty where
// nothing is known.
using Inaccuracies = std::vector<std::vector<double>>;

// One timing per contestant, in their order; ratios refer to the baseline, which is run whether it
// is among them or not. Triangles and segments. Refused: "no primitives", or how the promise is
// broken.
std::vector<Timing> time_contestants(std::span<const Batch> batches, const Contestants& contestants,
                                     const Contestant& baseline, const ContestClock& clock,
                                     const Inaccuracies& inaccuracies = {});

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// A class of failure: what a case must still do wrong while it is shrunk.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/contestants/contestant.hpp"
#include "experiments/judge/compare.hpp"

namespace clipscope::experiments {

// How many times beyond the threshold of the class each case is: more than 1 where it fails so,
// infinity where there is no threshold, 0 where it does not fail so or can't be asked. All cases
// are asked in as few batches as their volumes allow.
using Failing = std::function<std::vector<double>(std::span<const HardCase>)>;

// What one answer makes of the class: the comparison with the exact answer, the answer, what it was
// clipped against.
using ExcessOf = std::function<double(const Comparison&, const PolygonView&, const ClipVolume&)>;

// The contestant outlives the function, here and below.
Failing failing_by(const Contestant& contestant, ExcessOf excess_of);

// The outcome is that one. Threshold of `visible`: 1/256 px; the others have none.
Failing failing_with(const Contestant& contestant, Outcome outcome);

}  // namespace clipscope::experiments

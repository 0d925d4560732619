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
#include "experiments/judge/questions.hpp"

namespace clipscope::experiments {

// How many times beyond the threshold of the class each case is: more than 1 where it fails so,
// infinity where there is no threshold, 0 where it does not fail so or can't be asked. All cases
// are asked in as few batches as their volumes allow.
using Failing = std::function<std::vector<double>(std::span<const HardCase>)>;

// What the answer to one case makes of the class, and its comparison with the exact answer.
using ExcessOf = std::function<double(const HardCase&, const PolygonView&, const Comparison&)>;

// The contestant outlives the function, here and below.
Failing failing_by(const Contestant& contestant, ExcessOf excess_of);

// The answer breaks what the question asks, in its domain.
Failing failing_at(const Contestant& contestant, Question question);

// The same, but of cases alone that the bounds of `covers` speak of (Examined::in_domain): the
// numbers stay in the format, and the visible part keeps away from the eye.
Failing failing_in_domain(const Contestant& contestant, Failing failing);

// The outcome is that one. Threshold of `visible`: 1/256 px; the others have none.
Failing failing_with(const Contestant& contestant, Outcome outcome);

}  // namespace clipscope::experiments

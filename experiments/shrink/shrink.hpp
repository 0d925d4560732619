// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shrinking: from a case that fails to the smallest found that fails in the same class.
//
// Smaller is: fewer attributes, no clip distances, no options of depth and sides, no matrix, the
// standard frustum, and of all coordinates fewer significant bits, then exponents nearer to 0, then
// more of them equal (`cost_of` in simpler_cases.hpp). In a round all cases that are one step
// simpler are asked at once, then the best steps of the coordinates together; the cheapest that
// fails is taken, until none does.
//
// Source: Zeller and Hildebrandt, "Simplifying and Isolating Failure-Inducing Input", 2002; with
// numbers in place of lines. It finds a local minimum, not the smallest of all. Deterministic.
#pragma once

#include <cstddef>

#include "experiments/shrink/failing.hpp"

namespace clipscope::experiments {

// A triangle that has an area keeps one. A class with a threshold is kept, and at a comfortable
// distance from it: what is taken exceeds it at least so many times, or as much as the case given.
inline constexpr double kComfortableExcess = 2;

struct ShrinkLimits {
  std::size_t rounds = 60;
  std::size_t asked = 40'000;   // cases in all
  std::size_t at_once = 1'000;  // in a round
};
// Each failure that ends a guest's process, or waits for it, costs a new one.
inline constexpr ShrinkLimits kCostlyFailures{.rounds = 30, .asked = 400, .at_once = 24};

struct Shrunk {
  HardCase hard_case;     // with the outcome that the exact reference gives
  double excess = 0;      // see Failing; 0: asked again, the case given does not fail any more
  std::size_t asked = 0;  // cases, in so many rounds
  std::size_t rounds = 0;
};

// A case may have more vertices than its primitive if the class knows what they stand for; it has
// no expected outcome then.
// Pre-condition: the case is finite and no polygon, and its numbers are floats.
Shrunk shrink(const HardCase& hard_case, const Failing& failing, const ShrinkLimits& limits = {});

// The smallest on which the contestant breaks what the question asks. A case without an answer ends
// a guest's process: of such few are asked.
HardCase shrink(const Contestant& contestant, const HardCase& hard_case, Question question);

}  // namespace clipscope::experiments

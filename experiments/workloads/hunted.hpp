// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hunting for draw calls that a driver gets more wrong: hill climbing from those that it gets most
// wrong so far.
//
// Each beginning has a line of its own, whose best is changed in ulps, exponents, signs and by
// exchange of coordinates (`mutated` in experiments/hunt/breeding.hpp), or takes vertices of the
// best of another line. What is worse by the measure takes its place. Lines take turns, the worse
// more often. The search finds a lower bound of the worst error; it proves nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "experiments/drawcalls/draw_call.hpp"

namespace clipscope::experiments {

// How wrong it is drawn: more is worse, 0 is right. What can't be judged is 0.
using DrawError = std::function<double(const DrawCall&)>;

struct HuntedOptions {
  std::size_t evaluations = 1000;  // draw calls asked, the beginnings too
  std::uint64_t seed = 1;
};

struct HuntedDraw {
  DrawCall call;     // called as its beginning
  double error = 0;  // by the measure
  bool is_beginning = true;

  friend bool operator==(const HuntedDraw&, const HuntedDraw&) = default;
};

// The best of each line, the worst of all first; of equal ones in the order of the beginnings.
// Deterministic for a seed, if the measure is. Beginnings beyond the evaluations are left out.
// Pre-condition: the beginnings have vertices, and their numbers are finite.
std::vector<HuntedDraw> hunted_draws(std::span<const DrawCall> beginnings, const DrawError& error,
                                     const HuntedOptions& options);

}  // namespace clipscope::experiments

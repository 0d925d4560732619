// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shrinking a draw call: from one that fails to the smallest found that still does.
//
// Smaller is: fewer primitives, one list of them without indices, less asked for, a smaller target
// with a viewport as large, no options; and then what shrink.hpp calls smaller of its numbers,
// varyings counted as attributes. What is smaller is asked one by one, the smallest first, and
// taken as soon as it fails, so that a slow driver is not asked more than it must be.
//
// Source: Zeller and Hildebrandt, "Simplifying and Isolating Failure-Inducing Input", 2002.
// It finds a local minimum, not the smallest of all. Deterministic, if `still_fails` is; the
// smallest draw of a smallest draw is itself, unless the limits ended it.
#pragma once

#include <functional>

#include "experiments/drawcalls/draw_call.hpp"
#include "experiments/shrink/shrink.hpp"

namespace clipscope::experiments {

// A draw and its judgement cost about a millisecond.
inline constexpr ShrinkLimits kDrawLimits{.rounds = 40, .asked = 4'000, .at_once = 400};

// The call itself if nothing smaller fails, or if it does not fail either. Its name stays.
// What fails must keep its kind of failure and a distance from its threshold: `still_fails` sees to
// that. Pre-condition: coordinates, varyings and clip distances are finite.
DrawCall smallest_draw(DrawCall failing, const std::function<bool(const DrawCall&)>& still_fails,
                       const ShrinkLimits& limits = kDrawLimits);

// How much there is to a draw call.
double cost_of(const DrawCall& call);

}  // namespace clipscope::experiments

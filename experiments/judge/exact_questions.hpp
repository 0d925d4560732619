// SPDX-License-Identifier: GPL-3.0-or-later
//
// How an answer compares with the exact polygon, number by number: its winding, and whether it is
// faithful or correctly rounded (questions.hpp).
#pragma once

#include "experiments/judge/bit_promise.hpp"
#include "experiments/judge/compare.hpp"

namespace clipscope::experiments {

// Broken where both have an area of more than 1 px^2 and opposite signs of it.
Found judge_winding(const Comparison& comparison);

// Whether no float (or double) lies strictly between a number and the exact value, nor beside it
// where that is a float itself; of all numbers of vertices that stand for one another. Several
// exact vertices may share one of the answer, and the other way round, where they are so close.
// Excess: of the worst number, in units of the last place at the exact value. Not judged in
// double-double.
Found judge_faithful(const PolygonView& polygon, const TruthPolygon& truth,
                     const Comparison& comparison);

// In float alone. Any vertex may be the first; 0 may be -0.
Found judge_correctly_rounded(const PolygonView& polygon, const TruthPolygon& truth);

}  // namespace clipscope::experiments

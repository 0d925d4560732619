// SPDX-License-Identifier: GPL-3.0-or-later
//
// The distances to the user's planes: contestants get them as attributes in front of the batch's
// own, and give them back with every vertex. Who did not ask for them wants to be rid of them.
#pragma once

#include "experiments/contestants/contestant.hpp"

namespace clipscope::experiments {

// The answers to all primitives of a batch with the batch's own attributes alone.
// Pre-condition: the contestant takes it.
Answers clip_without_distances(const Contestant& contestant, const Batch& batch);

}  // namespace clipscope::experiments

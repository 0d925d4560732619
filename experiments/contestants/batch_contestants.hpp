// SPDX-License-Identifier: GPL-3.0-or-later
//
// The batch clippers (spaces/batch) as contestants of the full contract, in float: view space in, NDC out.
//
// They take clip-space triangles in another contract, the stage's: here that input is not applicable to them.
#pragma once

#include <vector>

#include "experiments/contestants/contestant.hpp"

namespace clipscope::experiments {

std::vector<Contestant<float>> batch_contestants();

}  // namespace clipscope::experiments

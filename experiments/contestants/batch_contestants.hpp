// SPDX-License-Identifier: GPL-3.0-or-later
//
// The batch clippers (spaces/batch) as contestants of the full contract, in float: view space in, NDC out.
//
// They take clip-space triangles in another contract, the stage's: here that input is not applicable to them.
#pragma once

#include <string_view>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "spaces/batch/batch.hpp"

namespace clipscope::experiments {

// "homogeneous/batch" and so on, in both timing contracts.
std::string_view batch_clipper_name(batch::Method method);

std::vector<Contestant<float>> batch_contestants();

}  // namespace clipscope::experiments

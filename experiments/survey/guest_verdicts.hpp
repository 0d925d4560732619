// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verdicts on guests, who are asked about many cases at once: a program is started once for all
// that are clipped against the same volume.
#pragma once

#include <span>
#include <vector>

#include "experiments/survey/verdicts.hpp"

namespace clipscope::experiments {

// One for each case, in their order. Of triangles the promise is what usually_asked has of a guest.
// Pre-condition: the cases are finite.
std::vector<CaseVerdict> judge_in_batches(const Contestant& guest,
                                          std::span<const HardCase* const> cases);

// The names of those that something comes out of, or that have no answer, in their order; `inputs`
// is how many the guest takes. The cases need not be finite.
struct DrawnCases {
  std::size_t inputs = 0;
  std::vector<std::string> names;
};
DrawnCases drawn_in_batches(const Contestant& guest, std::span<const HardCase* const> cases);

}  // namespace clipscope::experiments

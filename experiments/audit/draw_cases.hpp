// SPDX-License-Identifier: GPL-3.0-or-later
//
// A finding's draw call as cases for a corpus: from then on every clipper and driver meets them.
#pragma once

#include <vector>

#include "experiments/audit/audit.hpp"
#include "experiments/catalogue/hard_case.hpp"

namespace clipscope::experiments {

// The primitives of the finding's example, the violated one first and, if there are more than
// kMostCases, alone. Topology, indices, target and quantities are left out: an audit of the cases
// draws all forms of them.
inline constexpr std::size_t kMostCases = 4;
std::vector<HardCase> cases_of(const Audit& audit, const DriverFinding& finding);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// A hard case as those see it who are given clip coordinates only.
#pragma once

#include "experiments/catalogue/hard_case.hpp"

namespace clipscope::experiments {

// The case with its exact clip coordinates, each rounded once to float (to an infinity where they
// are beyond all floats). A case in clip space is left as it is.
HardCase projected(HardCase hard_case);

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// All clippers compiled for the scalar float.
#include "experiments/contestants/typed.hpp"

namespace clipscope::experiments {
template std::vector<Contestant> made_in<float>();
}

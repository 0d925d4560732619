// SPDX-License-Identifier: GPL-3.0-or-later
//
// All clippers compiled for the scalar counting.
#include "experiments/contestants/typed.hpp"

namespace clipscope::experiments {
template std::vector<Contestant> made_in<Counted>();
}

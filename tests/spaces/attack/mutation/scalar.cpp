// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a mutant of the clipper of one triangle is attacked through.
#include "tests/spaces/attack/contestants.hpp"

namespace clipscope::attack {

std::vector<Contestant> contestants() { return scalar_contestants(); }

}  // namespace clipscope::attack

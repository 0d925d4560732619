// SPDX-License-Identifier: GPL-3.0-or-later
//
// All forms of the clipper, for the tests and the program.
#include "tests/spaces/attack/contestants.hpp"

namespace clipscope::attack {

std::vector<Contestant> contestants() {
  std::vector<Contestant> r = scalar_contestants();
  for (Contestant& contestant : batch_contestants()) r.push_back(std::move(contestant));
  return r;
}

}  // namespace clipscope::attack

// SPDX-License-Identifier: GPL-3.0-or-later
//
// All clippers compiled for the scalar exact.
#include "experiments/contestants/contestants_of.hpp"

namespace clipscope::experiments {

template <>
std::span<const Contestant<Exact>> contestants<Exact>() {
  return contestants_of<Exact, 3>(AllClippers{});
}

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// All clippers compiled for the scalar counting.
#include "experiments/contestants/contestants_of.hpp"

namespace clipscope::experiments {

template <>
std::span<const Contestant<Counted>> contestants<Counted>() {
  return contestants_of<Counted, 3>(AllClippers{});
}

}  // namespace clipscope::experiments

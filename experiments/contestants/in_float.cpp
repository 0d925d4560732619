// SPDX-License-Identifier: GPL-3.0-or-later
//
// All clippers compiled for the scalar float.
#include "experiments/contestants/contestants_of.hpp"

namespace clipscope::experiments {

template <>
std::span<const Contestant<float>> contestants<float>() {
  return contestants_of<float, 3>(AllClippers{});
}

}  // namespace clipscope::experiments

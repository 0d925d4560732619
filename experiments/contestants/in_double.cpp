// SPDX-License-Identifier: GPL-3.0-or-later
//
// All clippers compiled for the scalar double.
#include "experiments/contestants/contestants_of.hpp"

namespace clipscope::experiments {

template <>
std::span<const Contestant<double>> contestants<double>() {
  return contestants_of<double, 3>(AllClippers{});
}

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// All clippers compiled for the scalar double.
#include "experiments/contestants/contestants_of.hpp"

namespace clipscope::experiments {

template <>
std::span<const Contestant<double>> contestants<double>() {
  return contestants_of<double, 3>(AllClippers{});
}

template <>
std::span<const Contestant<double, 2>> contestants<double, 2>() {
  return contestants_of<double, 2>(AllSegmentClippers{});
}

template <>
std::span<const Contestant<double, 1>> contestants<double, 1>() {
  return contestants_of<double, 1>(AllPointClippers{});
}

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// All clippers compiled for the scalar float.
#include "experiments/contestants/contestants_of.hpp"

namespace clipscope::experiments {

template <>
std::span<const Contestant<float>> contestants<float>() {
  return contestants_of<float, 3>(AllClippers{});
}

template <>
std::span<const Contestant<float, 2>> contestants<float, 2>() {
  return contestants_of<float, 2>(AllSegmentClippers{});
}

template <>
std::span<const Contestant<float, 1>> contestants<float, 1>() {
  return contestants_of<float, 1>(AllPointClippers{});
}

}  // namespace clipscope::experiments

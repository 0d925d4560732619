// SPDX-License-Identifier: GPL-3.0-or-later
//
// All clippers compiled for the scalar double_double.
#include "experiments/contestants/contestants_of.hpp"

namespace clipscope::experiments {

template <>
std::span<const Contestant<dd_real>> contestants<dd_real>() {
  return contestants_of<dd_real, 3>(AllClippers{});
}

template <>
std::span<const Contestant<dd_real, 2>> contestants<dd_real, 2>() {
  return contestants_of<dd_real, 2>(AllSegmentClippers{});
}

template <>
std::span<const Contestant<dd_real, 1>> contestants<dd_real, 1>() {
  return contestants_of<dd_real, 1>(AllPointClippers{});
}

}  // namespace clipscope::experiments

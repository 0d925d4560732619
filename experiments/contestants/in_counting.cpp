// SPDX-License-Identifier: GPL-3.0-or-later
//
// All clippers compiled for the scalar counting.
#include "experiments/contestants/contestants_of.hpp"

namespace clipscope::experiments {

template <>
std::span<const Contestant<Counted>> contestants<Counted>() {
  return contestants_of<Counted, 3>(AllClippers{});
}

template <>
std::span<const Contestant<Counted, 2>> contestants<Counted, 2>() {
  return contestants_of<Counted, 2>(AllSegmentClippers{});
}

template <>
std::span<const Contestant<Counted, 1>> contestants<Counted, 1>() {
  return contestants_of<Counted, 1>(AllPointClippers{});
}

}  // namespace clipscope::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
//
// All clippers compiled for the scalar exact.
#include "experiments/contestants/contestants_of.hpp"

namespace clipscope::experiments {

template <>
std::span<const Contestant<Exact>> contestants<Exact>() {
  return contestants_of<Exact, 3>(AllClippers{});
}

template <>
std::span<const Contestant<Exact, 2>> contestants<Exact, 2>() {
  return contestants_of<Exact, 2>(AllSegmentClippers{});
}

template <>
std::span<const Contestant<Exact, 1>> contestants<Exact, 1>() {
  return contestants_of<Exact, 1>(AllPointClippers{});
}

}  // namespace clipscope::experiments

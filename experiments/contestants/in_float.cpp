// SPDX-License-Identifier: GPL-3.0-or-later
//
// All clippers compiled for the scalar float, and after them the batch clippers, which there are in float alone.
#include "experiments/contestants/batch_contestants.hpp"
#include "experiments/contestants/contestants_of.hpp"

namespace clipscope::experiments {

template <>
std::span<const Contestant<float>> contestants<float>() {
  static const std::vector<Contestant<float>> all = [] {
    const auto scalar = contestants_of<float, 3>(AllClippers{});
    std::vector<Contestant<float>> list(scalar.begin(), scalar.end());
    for (const Contestant<float>& contestant : batch_contestants()) list.push_back(contestant);
    return list;
  }();
  return all;
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

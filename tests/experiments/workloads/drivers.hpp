// SPDX-License-Identifier: GPL-3.0-or-later
//
// Drivers by what they say of themselves, and what they are given to draw.
#pragma once

#include <vector>

#include "experiments/workloads/workload.hpp"

namespace clipscope::experiments {

// One that can all that can be asked.
inline DriverInfo able_driver() {
  DriverInfo info;
  info.subpixel_bits = 8;
  info.max_size = 16384;
  info.max_clip_distances = 8;
  info.max_point_size = 64;
  info.minus_one_to_one = info.zero_to_one = info.depth_clamp = true;
  info.provoking_first = info.provoking_last = true;
  info.quantities = Quantities().set();
  return info;
}

// One that can next to nothing: a Vulkan device without options that tells of smooth values alone.
inline DriverInfo poor_driver() {
  DriverInfo info;
  info.api = GraphicsApi::vulkan;
  info.max_size = 4096;
  info.zero_to_one = true;
  info.provoking_first = true;
  info.triangle_fans = false;
  for (const Quantity q : {Quantity::covered, Quantity::hits, Quantity::smooth}) {
    info.quantities.set(bit(q));
  }
  return info;
}

inline std::vector<DrawCall> draws(const WorkloadOptions& options, const DriverInfo& info) {
  std::vector<DrawCall> all;
  for_each_draw_call(options, info, [&](const DrawCall& call) { all.push_back(call); });
  return all;
}

}  // namespace clipscope::experiments

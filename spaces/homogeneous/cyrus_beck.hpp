// SPDX-License-Identifier: MIT
//
// Cyrus-Beck for segments in clip space, before the divide, against the volume's constant planes.
//
// Source: Cyrus and Beck, "Generalized Two- and Three-Dimensional Clipping", Computers & Graphics
// 3(1), 1978; clip-space planes: Blinn and Newell, "Clipping Using Homogeneous Coordinates",
// SIGGRAPH 1978.
// Guarantees: as cyrus_beck.hpp.
// Does not guarantee: coordinates within the volume to the last bit after the divide.
#pragma once

#include "spaces/cyrus_beck.hpp"
#include "spaces/homogeneous/segment_space.hpp"

namespace clipscope {

struct HomogeneousCyrusBeck : StartsInClipSpace<ClipSegmentThenDivide<CyrusBeck>> {
  static constexpr std::string_view name = "homogeneous/cyrus_beck";
  static constexpr std::string_view summary =
      "Cyrus-Beck in clip space against constant planes, then divide";
  static constexpr std::string_view source =
      "Cyrus and Beck, Generalized Two- and Three-Dimensional Clipping, 1978";
  static constexpr Promise promise{.ulps = kProjectUlps + kParametricUlps, .watertight = true};
};

}  // namespace clipscope

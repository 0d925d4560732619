// SPDX-License-Identifier: MIT
//
// Pruning for segments in clip space: the ends are cut back by each plane in turn, then divided.
//
// Source: Wijeweera and Kodituwakku, "An Approach for Line Clipping against a Convex Polyhedron",
// Ruhuna Journal of Science 7(1), 2016.
// Guarantees: as pruning.hpp.
// Does not guarantee: coordinates within the volume to the last bit after the divide.
#pragma once

#include "spaces/homogeneous/segment_space.hpp"
#include "spaces/pruning.hpp"

namespace clipscope {

struct HomogeneousPruning : StartsInClipSpace<ClipSegmentThenDivide<Pruning>> {
  static constexpr std::string_view name = "homogeneous/pruning";
  static constexpr std::string_view summary =
      "cuts the ends back by each plane of clip space in turn, then divides";
  static constexpr std::string_view source =
      "Wijeweera and Kodituwakku, An Approach for Line Clipping against a Convex Polyhedron, 2016";
  // Each of the six planes cuts one end at most.
  static constexpr Promise promise{.ulps = kProjectUlps + 6 * kSegmentCutUlps, .watertight = true};
};

}  // namespace clipscope

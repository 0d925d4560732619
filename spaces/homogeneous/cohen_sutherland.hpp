// SPDX-License-Identifier: MIT
//
// Cohen-Sutherland for segments in clip space, with 6-bit outcodes, before the divide.
//
// Source: Cohen and Sutherland, in Newman and Sproull, "Principles of Interactive Computer
// Graphics", 1973; homogeneous: Blinn and Newell, "Clipping Using Homogeneous Coordinates",
// SIGGRAPH 1978.
// Guarantees: as cohen_sutherland.hpp.
// Does not guarantee: coordinates within the volume to the last bit after the divide.
#pragma once

#include "spaces/cohen_sutherland.hpp"
#include "spaces/homogeneous/segment_space.hpp"

namespace clipscope {

struct HomogeneousCohenSutherland : StartsInClipSpace<ClipSegmentThenDivide<CohenSutherland>> {
  static constexpr std::string_view name = "homogeneous/cohen_sutherland";
  static constexpr std::string_view summary =
      "Cohen-Sutherland in clip space with 6-bit outcodes, then divide";
  static constexpr std::string_view source =
      "Newman and Sproull, Principles of Interactive Computer Graphics, 1973";
  // Each of the six planes cuts one end at most: a plane that both are outside of rejects.
  static constexpr Promise promise{.ulps = kProjectUlps + 6 * kSegmentCutUlps,
                                   .rotation_invariant = false};
};

}  // namespace clipscope

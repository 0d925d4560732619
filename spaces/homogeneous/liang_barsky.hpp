// SPDX-License-Identifier: MIT
//
// Liang-Barsky for segments in clip space, before the divide: classical, and with division-free
// tests.
//
// Source: Liang and Barsky, "A New Concept and Method for Line Clipping", ACM TOG 3(1), 1984;
// Blinn, "A Trip Down the Graphics Pipeline: Line Clipping", IEEE CG&A 11(1), 1991.
// Guarantees: as liang_barsky.hpp.
// Does not guarantee: coordinates within the volume to the last bit after the divide.
#pragma once

#include "spaces/homogeneous/segment_space.hpp"
#include "spaces/liang_barsky.hpp"

namespace clipscope {

template <DivisionPolicy kDivision>
struct HomogeneousLiangBarskyWith
    : StartsInClipSpace<ClipSegmentThenDivide<LiangBarsky<kDivision>>> {
  static constexpr bool kClassical = kDivision == DivisionPolicy::always;
  static constexpr std::string_view name =
      kClassical ? "homogeneous/liang_barsky" : "homogeneous/liang_barsky_division_free";
  static constexpr std::string_view summary =
      kClassical ? "Liang-Barsky in clip space, then divide"
                 : "Liang-Barsky in clip space that compares products and divides only to shorten";
  static constexpr std::string_view source =
      "Liang and Barsky, A New Concept and Method for Line Clipping, 1984";
  static constexpr Promise promise{.ulps = kProjectUlps + kParametricUlps, .watertight = true};
};

using HomogeneousLiangBarsky = HomogeneousLiangBarskyWith<DivisionPolicy::always>;
using HomogeneousLiangBarskyDivisionFree =
    HomogeneousLiangBarskyWith<DivisionPolicy::when_shortened>;

}  // namespace clipscope

// SPDX-License-Identifier: MIT
//
// Liang-Barsky for segments in the canonical view volume, after the divide, in three variants.
//
//   cvv/liang_barsky                a homogeneous cut by the near plane first
//   cvv/liang_barsky_division_free  the same, comparing products and dividing only to shorten
//   cvv/liang_barsky_naive          no near cut: divides whatever w it finds
//
// Source: Liang and Barsky, "A New Concept and Method for Line Clipping", ACM TOG 3(1), 1984.
// Guarantees: as liang_barsky.hpp.
// Does not guarantee: an answer where w <= 0 is left in front of the near plane, or anywhere if
// depths do not clip: such a segment is dropped. The naive variant draws the wrong segment where
// some w <= 0: the one through infinity becomes the one between the mirrored ends.
#pragma once

#include "spaces/cvv/segment_space.hpp"
#include "spaces/liang_barsky.hpp"

namespace clipscope {

template <DivisionPolicy kDivision>
struct CvvLiangBarskyWith : StartsInClipSpace<NearCutThenCvv<LiangBarsky<kDivision>>> {
  static constexpr bool kClassical = kDivision == DivisionPolicy::always;
  static constexpr std::string_view name =
      kClassical ? "cvv/liang_barsky" : "cvv/liang_barsky_division_free";
  static constexpr std::string_view summary =
      kClassical ? "homogeneous cut by the near plane, divide, then Liang-Barsky"
                 : "the same, comparing products and dividing only to shorten";
  static constexpr std::string_view source =
      "Liang and Barsky, A New Concept and Method for Line Clipping, 1984";
  // One end may be cut by the near plane, and then, like the other, by what binds it in the CVV.
  static constexpr Promise promise{.domain = Promise::Domain::divisible,
                                   .ulps = kProjectUlps + kSegmentCutUlps + kParametricUlps,
                                   .amplification = Promise::Amplification::w_ratio,
                                   .watertight = true};
};

using CvvLiangBarsky = CvvLiangBarskyWith<DivisionPolicy::always>;
using CvvLiangBarskyDivisionFree = CvvLiangBarskyWith<DivisionPolicy::when_shortened>;

struct CvvLiangBarskyNaive : StartsInClipSpace<DivideThenCvv<LiangBarskyClassical>> {
  static constexpr std::string_view name = "cvv/liang_barsky_naive";
  static constexpr std::string_view summary = "divide whatever w is, then Liang-Barsky";
  static constexpr std::string_view source =
      "Liang and Barsky, A New Concept and Method for Line Clipping, 1984";
  static constexpr Promise promise{.domain = Promise::Domain::in_front,
                                   .ulps = kProjectUlps + kParametricUlps,
                                   .amplification = Promise::Amplification::w_ratio,
                                   .watertight = true};
};

}  // namespace clipscope

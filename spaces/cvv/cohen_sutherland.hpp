// SPDX-License-Identifier: MIT
//
// Cohen-Sutherland for segments in the canonical view volume, with 6-bit outcodes, after the
// divide.
//
// Source: Cohen and Sutherland, in Newman and Sproull, "Principles of Interactive Computer
// Graphics", 1973.
// Guarantees: as cohen_sutherland.hpp.
// Does not guarantee: an answer where w <= 0 is left in front of the near plane, or anywhere if
// depths do not clip: such a segment is dropped.
#pragma once

#include "spaces/cohen_sutherland.hpp"
#include "spaces/cvv/segment_space.hpp"

namespace clipscope {

struct CvvCohenSutherland : StartsInClipSpace<NearCutThenCvv<CohenSutherland>> {
  static constexpr std::string_view name = "cvv/cohen_sutherland";
  static constexpr std::string_view summary =
      "homogeneous cut by the near plane, divide, then Cohen-Sutherland with 6-bit outcodes";
  static constexpr std::string_view source =
      "Newman and Sproull, Principles of Interactive Computer Graphics, 1973";
  // The near cut, then each of the six planes once: near may cut again what the divide moved.
  static constexpr Promise promise{.domain = Promise::Domain::divisible,
                                   .ulps = kProjectUlps + 7 * kSegmentCutUlps,
                                   .amplification = Promise::Amplification::w_ratio,
                                   .rotation_invariant = false};
};

}  // namespace clipscope

// SPDX-License-Identifier: MIT
//
// Liang-Barsky for segments in the window, classical and division-free: in the plane, and as
// clippers.
//
// Source: Liang and Barsky, "A New Concept and Method for Line Clipping", ACM TOG 3(1), 1984.
// Guarantees: as liang_barsky.hpp; no new point lies outside the side that made it.
// Does not guarantee (the clippers): an answer where w <= 0 is left after the cut by near and far.
#pragma once

#include "spaces/liang_barsky.hpp"
#include "spaces/window/segment_steps.hpp"

namespace clipscope {

namespace window {

template <Scalar T>
constexpr std::optional<Segment2<T>> liang_barsky(const Rectangle<T>& rectangle,
                                                  const Segment2<T>& segment) {
  return clip(LiangBarskyClassical{}, rectangle, segment);
}

template <Scalar T>
constexpr std::optional<Segment2<T>> liang_barsky_division_free(const Rectangle<T>& rectangle,
                                                                const Segment2<T>& segment) {
  return clip(LiangBarskyDivisionFree{}, rectangle, segment);
}

}  // namespace window

template <DivisionPolicy kDivision>
struct WindowLiangBarskyWith : StartsInClipSpace<DepthCutThenWindow<LiangBarsky<kDivision>>> {
  static constexpr bool kClassical = kDivision == DivisionPolicy::always;
  static constexpr std::string_view name =
      kClassical ? "window/liang_barsky" : "window/liang_barsky_division_free";
  static constexpr std::string_view summary =
      kClassical ? "near and far cut in clip space, divide, then Liang-Barsky in 2D"
                 : "the same, comparing products and dividing only to shorten";
  static constexpr std::string_view source =
      "Liang and Barsky, A New Concept and Method for Line Clipping, 1984";
  static constexpr Promise promise = window_promise(kParametricUlps, true);
};

using WindowLiangBarsky = WindowLiangBarskyWith<DivisionPolicy::always>;
using WindowLiangBarskyDivisionFree = WindowLiangBarskyWith<DivisionPolicy::when_shortened>;

}  // namespace clipscope

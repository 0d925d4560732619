// SPDX-License-Identifier: MIT
//
// Cohen-Sutherland for segments in the window, with 4-bit outcodes: in the plane, and as a clipper.
//
// Source: Cohen and Sutherland, in Newman and Sproull, "Principles of Interactive Computer
// Graphics", 1973, section 5.1.
// Guarantees: as cohen_sutherland.hpp; no new point lies outside the side that made it.
// Does not guarantee (the clipper): an answer where w <= 0 is left after the cut by near and far.
#pragma once

#include "spaces/cohen_sutherland.hpp"
#include "spaces/window/segment_steps.hpp"

namespace clipscope {

namespace window {

template <Scalar T>
constexpr std::optional<Segment2<T>> cohen_sutherland(const Rectangle<T>& rectangle,
                                                      const Segment2<T>& segment) {
  return clip(CohenSutherland{}, rectangle, segment);
}

}  // namespace window

struct WindowCohenSutherland : StartsInClipSpace<DepthCutThenWindow<CohenSutherland>> {
  static constexpr std::string_view name = "window/cohen_sutherland";
  static constexpr std::string_view summary =
      "near and far cut in clip space, divide, then Cohen-Sutherland in 2D with 4-bit outcodes";
  static constexpr std::string_view source =
      "Newman and Sproull, Principles of Interactive Computer Graphics, 1973";
  static constexpr Promise promise = window_promise(4 * kSegmentCutUlps, false);
};

}  // namespace clipscope

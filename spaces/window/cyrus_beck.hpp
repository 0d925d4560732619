// SPDX-License-Identifier: MIT
//
// Cyrus-Beck for segments in the window, against its four sides: in the plane, and as a clipper.
//
// Source: Cyrus and Beck, "Generalized Two- and Three-Dimensional Clipping", Computers & Graphics
// 3(1), 1978, for the rectangle, whose normals are the axes.
// Guarantees: as cyrus_beck.hpp; no new point lies outside the side that made it.
// Does not guarantee (the clipper): an answer where w <= 0 is left after the cut by near and far.
#pragma once

#include "spaces/cyrus_beck.hpp"
#include "spaces/window/segment_steps.hpp"

namespace clipscope {

namespace window {

template <Scalar T>
constexpr std::optional<Segment2<T>> cyrus_beck(const Rectangle<T>& rectangle,
                                                const Segment2<T>& segment) {
  return clip(CyrusBeck{}, rectangle, segment);
}

}  // namespace window

struct WindowCyrusBeck : StartsInClipSpace<DepthCutThenWindow<CyrusBeck>> {
  static constexpr std::string_view name = "window/cyrus_beck";
  static constexpr std::string_view summary =
      "near and far cut in clip space, divide, then Cyrus-Beck in 2D";
  static constexpr std::string_view source =
      "Cyrus and Beck, Generalized Two- and Three-Dimensional Clipping, 1978";
  static constexpr Promise promise = window_promise(kParametricUlps, true);
};

}  // namespace clipscope

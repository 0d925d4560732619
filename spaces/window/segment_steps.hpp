// SPDX-License-Identifier: MIT
//
// The way of a segment to a clipper in the window: what two dimensions can't see is cut in clip
// space.
//
// Near, far and clip distances cut in clip space, then comes the divide, then the method clips x
// and y.
#pragma once

#include "spaces/cvv/segment_space.hpp"
#include "spaces/window/rectangle.hpp"

namespace clipscope {

template <class Method>
struct DepthCutThenWindow {
  template <Scalar T, int K>
  requires std::invocable < Method, const WindowSegmentSpace<T, K>
  &, const std::array<NdcVertex<T, K>, 2>& >
         static constexpr void clip(const ClipVolume& volume, const ClipSegment<T, K>& segment,
                                    NdcPolygon<T, K>& out) {
    const auto divided = cvv::cut_and_divide(volume, ~kSidePlanes, segment);
    out.clear();
    if (divided) cvv::clip_divided<Method>(WindowSegmentSpace<T, K>(Rectangle<T>{}), *divided, out);
  }
};

// The promise of a method that takes so many u M in the window: an end may be cut before it in clip
// space.
constexpr Promise window_promise(double ulps, bool is_symmetric) {
  return {.domain = Promise::Domain::divisible,
          .ulps = kProjectUlps + kParametricUlps + ulps,
          .amplification = Promise::Amplification::w_ratio,
          .watertight = is_symmetric,
          .rotation_invariant = is_symmetric};
}

}  // namespace clipscope

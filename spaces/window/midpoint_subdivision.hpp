// SPDX-License-Identifier: MIT
//
// Sproull and Sutherland's midpoint subdivision: in the plane, and as a clipper in the window.
//
// Where outcodes neither accept nor reject, the visible point that is farthest from the other end
// is searched for each outside end by bisection: if the half beyond the midpoint is outside of one
// side, the midpoint becomes the far end of the search, else the near one. Additions, halvings and
// comparisons alone: it was made for hardware that had no divider.
// The search ends where the midpoint is one of its ends, to the last bit: by then these are
// neighbours in the scalar. Exact arithmetic knows no neighbours, so there the method does not
// exist.
// Source: Sproull and Sutherland, "A Clipping Divider", AFIPS Fall Joint Computer Conference 33,
// 1968; as textbooks describe it, by the outcodes of both halves. The hardware's integers have
// neighbours, too.
// A vertex's parameter is bisected along with x and y, and depth, 1/w and attributes are computed
// from it; a point of the plane has none.
// Guarantees: no division and no product but by one half; it ends; the same bits for a segment and
// its reverse. No new point lies outside the side that made it.
// Does not guarantee: an answer where the sum of two coordinates overflows. (The clipper:) an
// answer where w <= 0 is left after the cut by near and far.
#pragma once

#include <bit>

#include "spaces/window/rectangle.hpp"
#include "spaces/window/segment_steps.hpp"

namespace clipscope {

struct MidpointSubdivision {
  // The part of the segment that is inside, or none.
  template <PlanarSpace S>
  requires(kHasInfinity<typename S::ScalarType>) constexpr std::optional<SegmentIn<S>> operator()(
      const S& space, const SegmentIn<S>& segment) const {
    using T = typename S::ScalarType;
    const std::array<Outcode, 2> code = {space.outcode(segment[0]), space.outcode(segment[1])};
    if ((code[0] | code[1]) == 0) return segment;
    if ((code[0] & code[1]) != 0) return std::nullopt;
    const auto probe = [&](std::size_t end, int t) -> Probe<T> {
      const auto& p = space.position(segment[end]);
      return {{p[0], p[1]}, code[end], T(t)};
    };
    SegmentIn<S> ends = segment;
    for (std::size_t i = 0; i < 2; ++i) {
      if (code[i] == 0) continue;
      Search<S> search{space, probe(1 - i, 0), probe(i, 1)};
      if (!search.finds_visible()) return std::nullopt;
      ends[i] = search.place(segment[1 - i], segment[i]);
    }
    return ends;
  }

 private:
  template <class T>
  struct Probe {
    Vec2<T> at;
    Outcode code;
    T t;  // from the end that is kept to the one that is searched for
  };

  template <class S>
  struct Search {
    using T = typename S::ScalarType;
    static constexpr bool kIsPoint = std::same_as<typename S::PointType, Vec2<T>>;

    const S& space;
    Probe<T> near, far;  // far.code is never 0

    // Whether the near end is visible once nothing is left between the two.
    constexpr bool finds_visible() {
      for (;;) {
        Probe<T> middle = halfway();
        if (!is_finite(middle.at[0]) || !is_finite(middle.at[1])) return false;
        if (is_same_position(middle.at, near.at) || is_same_position(middle.at, far.at)) break;
        middle.code = side_outcode(space.rectangle(), middle.at);
        ((middle.code & far.code) != 0 ? far : near) = middle;
      }
      return near.code == 0;
    }

    constexpr Probe<T> halfway() const {
      const T half(0.5f);
      const T x = near.at[0] + far.at[0];
      const T y = near.at[1] + far.at[1];
      Probe<T> middle{{half * x, half * y}, 0, T(0)};
      if constexpr (!kIsPoint) {
        const T t = near.t + far.t;
        middle.t = half * t;
      }
      return middle;
    }

    // The near end, on the side that its neighbour is beyond.
    constexpr typename S::PointType place(const typename S::PointType& kept,
                                          const typename S::PointType& cut) const {
      const auto side = static_cast<Plane>(std::countr_zero(far.code));
      if constexpr (kIsPoint) {
        Vec2<T> at = near.at;
        at[side_axis(side)] = side_coordinate(space.rectangle(), side);
        return at;
      } else {
        return space.meet(side, kept, cut, near.t);
      }
    }
  };
};

namespace window {

template <Scalar T>
constexpr std::optional<Segment2<T>> midpoint_subdivision(const Rectangle<T>& rectangle,
                                                          const Segment2<T>& segment) {
  return clip(MidpointSubdivision{}, rectangle, segment);
}

}  // namespace window

// A midpoint is rounded once, by u M at most, and has the mean error of both ends beside that: the
// error grows by 2/3 u M a step where the ends are replaced in turn. Down to neighbours it takes as
// many steps as the scalar has digits, and 3 more: 110 in double-double, which makes 74. 7 for the
// rounding of the parameter and of the vertex that is computed from it.
inline constexpr double kBisectionUlps = 74 + 7;

struct WindowMidpointSubdivision : StartsInClipSpace<DepthCutThenWindow<MidpointSubdivision>> {
  static constexpr std::string_view name = "window/midpoint_subdivision";
  static constexpr std::string_view summary =
      "near and far cut in clip space, divide, then bisection in 2D; in floating point only";
  static constexpr std::string_view source = "Sproull and Sutherland, A Clipping Divider, 1968";
  static constexpr Promise promise = window_promise(kBisectionUlps, true);
};

}  // namespace clipscope

// SPDX-License-Identifier: MIT
//
// Kodituwakku, Wijeweera and Chamikara's segment clipper: in the plane, and as a clipper in the
// window.
//
// No classification: of a line y = m x + c every end that is beyond the left or right side moves
// there, and then to the bottom or top side if it is beyond that. The two ends of a line that
// misses the window come to rest at one place, and that rejects it. Horizontal and vertical lines
// have neither m nor c; their ends move along their axis.
// Source: Kodituwakku, Wijeweera and Chamikara, "An Efficient Algorithm for Line Clipping in
// Computer Graphics Programming", Ceylon Journal of Science (Physical Sciences) 17, 2013, section
// 2.1 and appendix.
// Repaired: the paper rejects what is narrower than 1, a pixel, after it is cut; here, what has no
// width. It rejects horizontal and vertical lines that lie in a side, and points on a side; here
// they are inside.
// Guarantees: no new point lies outside the side that made it last.
// Does not guarantee: any bound on the error in rounded arithmetic: m and c have the width of the
// segment in their denominator, so that c loses the digits of steep lines; the same bits for a
// segment and its reverse in double-double. (The clipper:) an answer where w <= 0 is left after the
// cut by near and far.
#pragma once

#include "spaces/window/planar_ends.hpp"
#include "spaces/window/segment_steps.hpp"

namespace clipscope {

struct KodituwakkuWijeweeraChamikara {
  // The part of the segment that is inside, or none.
  template <PlanarSpace S>
  constexpr std::optional<SegmentIn<S>> operator()(const S& space,
                                                   const SegmentIn<S>& segment) const {
    using T = typename S::ScalarType;
    std::array<PlanarEnd<T>, 2> ends = planar_ends(space, segment);
    const Vec2<T>& p = ends[0].at;
    const Vec2<T>& q = ends[1].at;
    bool visible = false;
    if (p[0] == q[0]) {
      visible = p[1] == q[1] ? space.outcode(segment[0]) == 0  //
                             : clip_along<1>(space.rectangle(), ends);
    } else if (p[1] == q[1]) {
      visible = clip_along<0>(space.rectangle(), ends);
    } else {
      visible = clip_sloping(space.rectangle(), ends);
    }
    if (!visible) return std::nullopt;
    return place_ends(space, segment, ends);
  }

 private:
  template <Scalar T>
  static constexpr bool clip_sloping(const Rectangle<T>& r, std::array<PlanarEnd<T>, 2>& ends) {
    const Vec2<T>& p = ends[0].at;
    const Vec2<T>& q = ends[1].at;
    const T width = p[0] - q[0];
    const T height = p[1] - q[1];
    const T product = p[0] * q[1] - q[0] * p[1];
    const T m = height / width;
    const T c = product / width;
    for (PlanarEnd<T>& end : ends) {
      if (end.at[0] < r.left) {
        end.move(Plane::left, r.left, T(m * r.left + c));
      } else if (r.right < end.at[0]) {
        end.move(Plane::right, r.right, T(m * r.right + c));
      }
      if (end.at[1] < r.bottom) {
        end.move(Plane::bottom, r.bottom, T((r.bottom - c) / m));
      } else if (r.top < end.at[1]) {
        end.move(Plane::top, r.top, T((r.top - c) / m));
      }
    }
    return ends[0].at[0] != ends[1].at[0];
  }

  // A horizontal line (axis 0) or a vertical one (axis 1).
  template <int kAxis, Scalar T>
  static constexpr bool clip_along(const Rectangle<T>& r, std::array<PlanarEnd<T>, 2>& ends) {
    constexpr std::array<Plane, 2> kEnds =
        kAxis == 0 ? std::array{Plane::left, Plane::right} : std::array{Plane::bottom, Plane::top};
    constexpr std::array<Plane, 2> kBeside =
        kAxis == 0 ? std::array{Plane::bottom, Plane::top} : std::array{Plane::left, Plane::right};
    const T beside = ends[0].at[1 - kAxis];
    if (beside < side_coordinate(r, kBeside[0]) || side_coordinate(r, kBeside[1]) < beside) {
      return false;
    }
    for (PlanarEnd<T>& end : ends) {
      if (end.at[kAxis] < side_coordinate(r, kEnds[0])) {
        end.move(kEnds[0], side_coordinate(r, kEnds[0]), beside);
      } else if (side_coordinate(r, kEnds[1]) < end.at[kAxis]) {
        end.move(kEnds[1], side_coordinate(r, kEnds[1]), beside);
      }
    }
    return ends[0].at[kAxis] != ends[1].at[kAxis];
  }
};

namespace window {

template <Scalar T>
constexpr std::optional<Segment2<T>> kodituwakku_wijeweera_chamikara(const Rectangle<T>& rectangle,
                                                                     const Segment2<T>& segment) {
  return clip(KodituwakkuWijeweeraChamikara{}, rectangle, segment);
}

}  // namespace window

struct WindowKodituwakkuWijeweeraChamikara
    : StartsInClipSpace<DepthCutThenWindow<KodituwakkuWijeweeraChamikara>> {
  static constexpr std::string_view name = "window/kodituwakku_wijeweera_chamikara";
  static constexpr std::string_view summary =
      "near and far cut in clip space, divide, then by slope and intercept in 2D, unclassified";
  static constexpr std::string_view source =
      "Kodituwakku, Wijeweera and Chamikara, An Efficient Algorithm for Line Clipping, 2013";
  static constexpr Promise promise = window_promise(kUnbounded, false);
};

}  // namespace clipscope

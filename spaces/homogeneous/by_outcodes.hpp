// SPDX-License-Identifier: MIT
//
// The way of a triangle to a clipper that cuts in clip space, plane after plane: outcodes accept
// what is inside and reject what is outside one plane without computing anything; the rest is cut
// by just the planes that some vertex is outside of, and divided.
//
// Source: outcodes: Cohen and Sutherland, in Newman and Sproull, "Principles of Interactive
// Computer Graphics", 1973; homogeneous: Blinn and Newell, "Clipping Using Homogeneous
// Coordinates", SIGGRAPH 1978.
#pragma once

#include "spaces/clipper.hpp"
#include "spaces/cut.hpp"
#include "spaces/homogeneous/divide.hpp"
#include "spaces/planes.hpp"

namespace clipscope {

// Near first: what is behind the eye goes at once.
inline constexpr std::array<Plane, kPlanes> kNearFirst = {Plane::near,  Plane::far,    Plane::left,
                                                          Plane::right, Plane::bottom, Plane::top};

// Empties a polygon that has a vertex with a NaN or an infinity.
template <Scalar T, int K>
constexpr void clear_unless_finite(ClipPolygon<T, K>& polygon) {
  for (const ClipVertex<T, K>& v : polygon) {
    if (!has_finite_position(v)) {
      polygon.clear();
      return;
    }
  }
}

// The static Method::cut(volume, planes, polygon, scratch) gives what is left inside of the planes,
// in one of the two lists; nothing where a position is not finite. Method::is_cut_anyway(positions)
// says whether it cuts by more than planes that outcodes know.
template <class Method>
struct CutsByOutcodes : StartsAtClipPositions<CutsByOutcodes<Method>> {
  template <Scalar T, Space S, int K>
  static constexpr void clip(const ClipVolume& volume, const std::array<Vec4<T>, 3>& positions,
                             const Triangle<S, T, K>& source, NdcPolygon<T, K>& out) {
    const OutcodeSummary code = summarize_outcodes(
        volume, source, [&](std::size_t i) { return clip_outcode(volume.depth, positions[i]); });
    if (code.all != 0) {
      out.clear();
    } else if (code.any == 0 && !Method::is_cut_anyway(positions)) {
      divide_inside(volume, positions, source, out);
    } else {
      ClipPolygon<T, K> polygon, scratch;
      polygon.assign(ClipTriangle<T, K>{ClipVertex<T, K>{positions[0], source[0].attributes},
                                        ClipVertex<T, K>{positions[1], source[1].attributes},
                                        ClipVertex<T, K>{positions[2], source[2].attributes}});
      divide(Method::cut(volume, code.any, polygon, scratch), out);
    }
  }

  template <Scalar T, int K>
  static constexpr ClipPolygon<T, K> cut(const ClipVolume& volume,
                                         const ClipTriangle<T, K>& triangle) {
    const OutcodeSummary code = summarize_outcodes(volume, triangle, [&](std::size_t i) {
      return clip_outcode(volume.depth, triangle[i].position);
    });
    ClipPolygon<T, K> polygon, scratch;
    if (code.all != 0 || is_beyond_open_side(volume, triangle)) {
      return polygon;  // not {}, which would write zeros all over it
    }
    const std::array positions = {triangle[0].position, triangle[1].position, triangle[2].position};
    if (code.any == 0 && !Method::is_cut_anyway(positions)) return divisible<T, K>(triangle);
    polygon.assign(triangle);
    return divisible<T, K>(Method::cut(volume, code.any, polygon, scratch));
  }

  template <Scalar T>
  static constexpr bool is_cut_anyway(const std::array<Vec4<T>, 3>&) {
    return false;
  }
};

}  // namespace clipscope

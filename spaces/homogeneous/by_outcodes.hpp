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
#include "spaces/measured.hpp"
#include "spaces/planes.hpp"

namespace clipscope {

// Near first: what is behind the eye goes at once.
inline constexpr std::array<Plane, kPlanes> kNearFirst = {Plane::near,  Plane::far,    Plane::left,
                                                          Plane::right, Plane::bottom, Plane::top};

// Empties a polygon that has a vertex with a NaN or an infinity.
template <class V>
constexpr void clear_unless_finite(VertexList<V>& polygon) {
  for (const V& v : polygon) {
    if (!has_finite_position(v)) {
      polygon.clear();
      return;
    }
  }
}

// The static Method::cut(volume, planes, polygon, scratch) gives what is left inside of the planes,
// in one of the two lists; nothing where a position is not finite. Their vertices carry distances
// where several planes cut (measured.hpp), unless Method::kMeasures is false.
// Method::is_cut_anyway(positions) says whether it cuts by more than planes that outcodes know.
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
      const ClipTriangle<T, K> triangle = {ClipVertex<T, K>{positions[0], source[0].attributes},
                                           ClipVertex<T, K>{positions[1], source[1].attributes},
                                           ClipVertex<T, K>{positions[2], source[2].attributes}};
      cut_and_then(volume, code.any, triangle, [&](const auto& rest) { divide(rest, out); });
    }
  }

  template <Scalar T, int K>
  static constexpr ClipPolygon<T, K> cut(const ClipVolume& volume,
                                         const ClipTriangle<T, K>& triangle) {
    const OutcodeSummary code = summarize_outcodes(volume, triangle, [&](std::size_t i) {
      return clip_outcode(volume.depth, triangle[i].position);
    });
    ClipPolygon<T, K> out;
    if (code.all != 0 || is_beyond_open_side(volume, triangle)) {
      return out;  // not {}, which would write zeros all over it
    }
    const std::array positions = {triangle[0].position, triangle[1].position, triangle[2].position};
    const auto take = [&](const auto& rest) { take_divisible(rest, out); };
    if (code.any == 0 && !Method::is_cut_anyway(positions)) {
      take(triangle);
    } else {
      cut_and_then(volume, code.any, triangle, take);
    }
    return out;
  }

  // f(rest): what is left of a triangle inside of the planes of the code, which are all that a
  // vertex is outside of.
  template <Scalar T, int K, class F>
  static constexpr void cut_and_then(const ClipVolume& volume, Outcode planes,
                                     const ClipTriangle<T, K>& triangle, F&& f) {
    if constexpr (Method::kMeasures) {
      const bool is_cut_once =
          is_single(planes) &&
          !Method::is_cut_anyway(
              std::array{triangle[0].position, triangle[1].position, triangle[2].position});
      if (!is_cut_once) {
        MeasuredPolygon<Space::clip, T, K> polygon, scratch;
        for (const ClipVertex<T, K>& v : triangle) polygon.push_back(measured(volume.depth, v));
        return f(Method::cut(volume, planes, polygon, scratch));
      }
    }
    ClipPolygon<T, K> polygon, scratch;
    polygon.assign(triangle);
    f(Method::cut(volume, planes, polygon, scratch));
  }

  static constexpr bool kMeasures = true;

  template <Scalar T>
  static constexpr bool is_cut_anyway(const std::array<Vec4<T>, 3>&) {
    return false;
  }
};

}  // namespace clipscope

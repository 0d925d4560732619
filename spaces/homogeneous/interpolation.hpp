// SPDX-License-Identifier: MIT
//
// Sutherland-Hodgman in clip space with new vertices interpolated as textbooks and production code
// do it, in three variants. With d_in > 0 > d_out at the ends of an edge:
//
//   homogeneous/from_inside    in + t (out - in), t = d_in / (d_in - d_out)
//   homogeneous/from_outside   out + t (in - out), t = d_out / (d_out - d_in): Mesa's draw module
//   homogeneous/weighted_ends  d_out / (d_out - d_in) in + d_in / (d_in - d_out) out: SwiftShader
//
// Distances of new vertices are those of their rounded positions, as everywhere there. What
// homogeneous/sutherland_hodgman does instead: it takes the nearer of the two ends (cut.hpp), and
// carries distances (measured.hpp).
// Source: Sutherland and Hodgman, "Reentrant Polygon Clipping", CACM 17(1), 1974; Whitwell,
// draw_pipe_clip.c of Mesa (interp, do_clip_tri), 2007; SwiftShader, Clipper.cpp (clipEdge).
// Left out of Mesa's: a vertex on the plane makes a second copy of itself there. Added to
// SwiftShader's, which interpolates positions alone: attributes are in + t (out - in) with
// t = d_in / (d_in - d_out), so that constants remain. SwiftShader multiplies both ends by
// distances and then by one reciprocal; products of two coordinates overflow at 2^64, and so does
// the reciprocal of a subnormal number, so here each weight is a quotient of its own.
// Does not guarantee: what homogeneous/sutherland_hodgman does not; equal bits on a shared edge of
// neighbours that are cut by different planes.
#pragma once

#include "spaces/homogeneous/by_outcodes.hpp"

namespace clipscope {

enum class NewVertex { from_inside, from_outside, weighted_ends };

template <NewVertex kNewVertex>
struct HomogeneousInterpolating : CutsByOutcodes<HomogeneousInterpolating<kNewVertex>> {
  static constexpr bool kIsWeighted = kNewVertex == NewVertex::weighted_ends;

  static constexpr std::string_view name = [] {
    switch (kNewVertex) {
      case NewVertex::from_outside: return "homogeneous/from_outside";
      case NewVertex::weighted_ends: return "homogeneous/weighted_ends";
      default: return "homogeneous/from_inside";
    }
  }();
  static constexpr std::string_view summary = [] {
    switch (kNewVertex) {
      case NewVertex::from_outside:
        return "Sutherland-Hodgman in clip space, new vertices from the outside end, as Mesa";
      case NewVertex::weighted_ends:
        return "Sutherland-Hodgman in clip space, ends weighted by distances, as SwiftShader";
      default: return "Sutherland-Hodgman in clip space, new vertices from the inside end";
    }
  }();
  static constexpr std::string_view source = [] {
    switch (kNewVertex) {
      case NewVertex::from_outside: return "Whitwell, Mesa: draw_pipe_clip.c, 2007";
      case NewVertex::weighted_ends: return "SwiftShader: Clipper.cpp, 2016";
      default: return "Sutherland and Hodgman, Reentrant Polygon Clipping, 1974";
    }
  }();
  // One cut, weighted: 2 for each of two products and distances, 1 for their difference, 3 for the
  // reciprocal and its product, which is less than the 14 of kChainUlps.
  static constexpr Promise promise{.ulps = kChainUlps, .scale_invariant = !kIsWeighted};

  static constexpr bool kMeasures = false;

  using CutsByOutcodes<HomogeneousInterpolating>::cut;

  template <Scalar T, int K>
  static constexpr const ClipPolygon<T, K>& cut(const ClipVolume& volume, Outcode planes,
                                                ClipPolygon<T, K>& polygon,
                                                ClipPolygon<T, K>& scratch) {
    clear_unless_finite(polygon);
    using Vertices = ClipPolygon<T, K>;
    Vertices& rest = step_by_planes(
        polygon, scratch, planes, kNearFirst, [&](Plane plane, const Vertices& in, Vertices& out) {
          cut_by_distances(
              in, out,
              [&](const ClipVertex<T, K>& v) { return signed_distance(volume.depth, plane, v); },
              meet<T, K>);
        });
    clear_unless_finite(rest);
    return rest;
  }

 private:
  template <Scalar T, int K>
  static constexpr ClipVertex<T, K> meet(const ClipVertex<T, K>& inside,
                                         const ClipVertex<T, K>& outside, const T& d_inside,
                                         const T& d_outside) {
    if constexpr (kIsWeighted) {
      return weighted(inside, outside, d_inside, d_outside);
    } else if constexpr (kNewVertex == NewVertex::from_outside) {
      const T t = cut_parameter(T(-d_outside), T(-d_inside));
      return interpolate(outside, inside, t);
    } else {
      const T t = cut_parameter(d_inside, d_outside);
      return interpolate(inside, outside, t);
    }
  }

  template <Scalar T, int K>
  static constexpr ClipVertex<T, K> weighted(const ClipVertex<T, K>& inside,
                                             const ClipVertex<T, K>& outside, const T& d_inside,
                                             const T& d_outside) {
    const T t = cut_parameter(d_inside, d_outside);
    const T kept = cut_parameter(T(-d_outside), T(-d_inside));
    ClipVertex<T, K> r = inside;
    for (int i = 0; i < 4; ++i) r.position[i] = kept * inside.position[i] + t * outside.position[i];
    for (int k = 0; k < r.attributes.size(); ++k) {
      const T step = outside.attributes[k] - inside.attributes[k];
      r.attributes[k] = inside.attributes[k] + t * step;
    }
    return r;
  }
};

using HomogeneousFromInside = HomogeneousInterpolating<NewVertex::from_inside>;
using HomogeneousFromOutside = HomogeneousInterpolating<NewVertex::from_outside>;
using HomogeneousWeightedEnds = HomogeneousInterpolating<NewVertex::weighted_ends>;

}  // namespace clipscope

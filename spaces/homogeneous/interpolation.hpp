// SPDX-License-Identifier: MIT
//
// Sutherland-Hodgman in clip space with new vertices interpolated as production code does it, in
// three variants. With d_in > 0 > d_out at the ends of an edge:
//
//   homogeneous/from_outside   out + t (in - out), t = d_out / (d_out - d_in): Mesa's draw module
//   homogeneous/weighted_ends  d_out / (d_out - d_in) in + d_in / (d_in - d_out) out: SwiftShader
//   homogeneous/nearer_end     from the end nearer to the plane: near it both t and what t is
//                              multiplied by are small, and hence what they add to the rounding
//                              of that end: S2 Geometry, Manifold
//
// Source: Whitwell, draw_pipe_clip.c of Mesa (interp, do_clip_tri), 2007; SwiftShader, Clipper.cpp
// (clipEdge); S2 Geometry, s2edge_clipping.h (InterpolateDouble), which carries a proof that the
// error is 2.25 DBL_EPSILON at most; the same in Manifold's boolean operations (Interpolate).
// Left out of Mesa's: a vertex on the plane makes a second copy of itself there. Added to
// SwiftShader's, which interpolates positions alone: attributes are in + t (out - in) with
// t = d_in / (d_in - d_out), so that constants remain. SwiftShader multiplies both ends by
// distances and then by one reciprocal; products of two coordinates overflow at 2^64, and so does
// the reciprocal of a subnormal number, so here each weight is a quotient of its own.
// Does not guarantee: what homogeneous/sutherland_hodgman does not.
#pragma once

#include "spaces/homogeneous/by_outcodes.hpp"

namespace clipscope {

enum class NewVertex { from_outside, weighted_ends, nearer_end };

template <NewVertex kNewVertex>
struct HomogeneousInterpolating : CutsByOutcodes<HomogeneousInterpolating<kNewVertex>> {
  static constexpr bool kIsWeighted = kNewVertex == NewVertex::weighted_ends;

  static constexpr std::string_view name = [] {
    switch (kNewVertex) {
      case NewVertex::from_outside: return "homogeneous/from_outside";
      case NewVertex::weighted_ends: return "homogeneous/weighted_ends";
      default: return "homogeneous/nearer_end";
    }
  }();
  static constexpr std::string_view summary = [] {
    switch (kNewVertex) {
      case NewVertex::from_outside:
        return "Sutherland-Hodgman in clip space, new vertices from the outside end, as Mesa";
      case NewVertex::weighted_ends:
        return "Sutherland-Hodgman in clip space, ends weighted by distances, as SwiftShader";
      default: return "Sutherland-Hodgman in clip space, new vertices from the nearer end";
    }
  }();
  static constexpr std::string_view source = [] {
    switch (kNewVertex) {
      case NewVertex::from_outside: return "Whitwell, Mesa: draw_pipe_clip.c, 2007";
      case NewVertex::weighted_ends: return "SwiftShader: Clipper.cpp, 2016";
      default: return "S2 Geometry: s2edge_clipping.h, InterpolateDouble";
    }
  }();
  // One cut, weighted: 2 for each of two products and distances, 1 for their difference, 3 for the
  // reciprocal and its product, which is less than the 14 of kChainUlps.
  static constexpr Promise promise{.ulps = kChainUlps, .scale_invariant = !kIsWeighted};

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
    } else {
      const T beyond = -d_outside;
      if (kNewVertex == NewVertex::nearer_end && d_inside <= beyond) {
        const T t = cut_parameter(d_inside, d_outside);
        return interpolate(inside, outside, t);
      }
      const T t = cut_parameter(beyond, T(-d_inside));
      return interpolate(outside, inside, t);
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

using HomogeneousFromOutside = HomogeneousInterpolating<NewVertex::from_outside>;
using HomogeneousWeightedEnds = HomogeneousInterpolating<NewVertex::weighted_ends>;
using HomogeneousNearerEnd = HomogeneousInterpolating<NewVertex::nearer_end>;

}  // namespace clipscope

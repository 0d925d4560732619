// SPDX-License-Identifier: MIT
//
// Divide first, then Sutherland-Hodgman in the canonical view volume (CVV), in three variants.
//
//   cvv/naive        positions and attributes interpolated linearly in NDC
//   cvv/perspective  attributes by way of a/w and 1/w, which are linear in NDC
//   cvv/near_first   a homogeneous cut by the near plane before the divide, then cvv/perspective
//
// Perspective-correct interpolation: Blinn, "Hyperbolic Interpolation", IEEE CG&A 12(4), 1992;
// Heckbert and Moreton, "Interpolation for Polygon Texture Mapping and Shading", 1991.
// Does not guarantee: anything sensible where some w <= 0: dividing by a negative w mirrors a
// vertex to the other side, dividing by 0 sends it to infinity. What that does to a picture is what
// the first two are here to show. For cvv/near_first the near cut leaves w > 0 of whatever comes
// from view space; a clip-space triangle that no projection makes may keep w <= 0 in front of the
// near plane, and is then dropped. A triangle divided by w = 0 yields nothing in scalars that know
// no infinity.
#pragma once

#include "spaces/clipper.hpp"
#include "spaces/cut.hpp"
#include "spaces/planes.hpp"

namespace clipscope {

enum class AttributeInterpolation { affine, perspective };

namespace cvv {

// The point at t between two NDC vertices with attributes that are linear in eye space: the
// eye-space parameter is t' = t w_outside^-1 / ((1 - t) w_inside^-1 + t w_outside^-1).
template <Scalar T, int K>
constexpr NdcVertex<T, K> interpolate_perspective(const NdcVertex<T, K>& inside,
                                                  const NdcVertex<T, K>& outside, const T& t) {
  NdcVertex<T, K> r;
  for (int i = 0; i < 4; ++i) {
    r.position[i] = inside.position[i] + t * (outside.position[i] - inside.position[i]);
  }
  r.attributes.resize(inside.attributes.size());
  const T inv_w = r.position[3];
  T eye_t(0);
  if (can_divide_by(inv_w)) eye_t = t * outside.position[3] / inv_w;
  if (!is_finite(eye_t)) eye_t = T(0);  // where the sign of w changes: infinity times 0 is no 0
  for (int k = 0; k < r.attributes.size(); ++k) {
    r.attributes[k] = inside.attributes[k] + eye_t * (outside.attributes[k] - inside.attributes[k]);
  }
  return r;
}

// Cuts a polygon that was divided already by the planes given, in place.
template <AttributeInterpolation kAttributes, Scalar T, int K>
constexpr void cut_planes(DepthRange depth, Outcode planes, NdcPolygon<T, K>& polygon) {
  NdcPolygon<T, K> scratch;
  NdcPolygon<T, K>* rest = nullptr;
  const auto distance = [&](Plane plane, const NdcVertex<T, K>& v) {
    return signed_distance(depth, plane, v);
  };
  if constexpr (kAttributes == AttributeInterpolation::affine) {
    rest = &cut_by_planes(polygon, scratch, planes, kAllPlanes, distance);
  } else {
    rest = &cut_by_planes(polygon, scratch, planes, kAllPlanes, distance,
                          interpolate_perspective<T, K>);
  }
  if (rest != &polygon) polygon = *rest;
  polygon.drop_if_degenerate();
  clear_if_overflowed(polygon);
}

// Divides and cuts by those of the planes given that some divided vertex is outside of.
template <AttributeInterpolation kAttributes, Scalar T, int K>
constexpr void divide_and_cut(const ClipVolume& volume, Outcode planes,
                              const ClipPolygon<T, K>& polygon, NdcPolygon<T, K>& out) {
  out.clear();
  Outcode all = ~Outcode{0};
  Outcode any = 0;
  for (const ClipVertex<T, K>& v : polygon) {
    if (!can_divide_by(v.position[3])) {
      out.clear();
      return;
    }
    const NdcVertex<T, K> ndc = to_ndc(v);
    const Outcode code =
        ndc_outcode(volume.depth, ndc.position) | clip_distance_outcode(volume, v.attributes);
    all &= code;
    any |= code;
    out.push_back(ndc);
  }
  if ((all & planes) != 0) {
    out.clear();
  } else if ((any & planes) != 0) {
    cut_planes<kAttributes>(volume.depth, any & planes, out);
  }
}

}  // namespace cvv

template <AttributeInterpolation kAttributes>
struct CvvSutherlandHodgman : StartsInClipSpace<CvvSutherlandHodgman<kAttributes>> {
  static constexpr bool kAffine = kAttributes == AttributeInterpolation::affine;
  static constexpr std::string_view name = kAffine ? "cvv/naive" : "cvv/perspective";
  static constexpr std::string_view summary =
      kAffine ? "divide, then Sutherland-Hodgman in NDC, attributes interpolated as positions are"
              : "divide, then Sutherland-Hodgman in NDC with perspective-correct attributes";
  static constexpr std::string_view source =
      kAffine ? "Sutherland and Hodgman, Reentrant Polygon Clipping, 1974"
              : "Blinn, Hyperbolic Interpolation, 1992";
  static constexpr Promise promise{.domain = Promise::Domain::in_front,
                                   .attributes = !kAffine,
                                   .ulps = kChainUlps,
                                   .amplification = Promise::Amplification::w_ratio,
                                   .clip_distances = !kAffine};

  template <Scalar T, int K>
  static constexpr void clip(const ClipVolume& volume, const ClipTriangle<T, K>& triangle,
                             NdcPolygon<T, K>& out) {
    out.clear();
    if (!has_finite_positions(triangle)) return;
    ClipPolygon<T, K> polygon;
    polygon.assign(triangle);
    cvv::divide_and_cut<kAttributes>(volume, planes_of(volume), polygon, out);
    clear_if_overflowed(out);
  }
};

using CvvNaive = CvvSutherlandHodgman<AttributeInterpolation::affine>;
using CvvPerspective = CvvSutherlandHodgman<AttributeInterpolation::perspective>;

struct CvvNearFirst : StartsInClipSpace<CvvNearFirst> {
  static constexpr std::string_view name = "cvv/near_first";
  static constexpr std::string_view summary =
      "homogeneous cut by the near plane, divide, then Sutherland-Hodgman in NDC";
  static constexpr std::string_view source =
      "Blinn, A Trip Down the Graphics Pipeline: Line Clipping, 1991";
  static constexpr Promise promise{.domain = Promise::Domain::divisible,
                                   .ulps = kChainUlps,
                                   .amplification = Promise::Amplification::w_ratio,
                                   .depth_clamp = false};

  template <Scalar T, int K>
  static constexpr void clip(const ClipVolume& volume, const ClipTriangle<T, K>& triangle,
                             NdcPolygon<T, K>& out) {
    out.clear();
    if (!has_finite_positions(triangle)) return;
    ClipPolygon<T, K> polygon, other;
    polygon.assign(triangle);
    cut_if_crossed(polygon, other, [&](const ClipVertex<T, K>& v) {
      return signed_distance(volume.depth, Plane::near, v);
    });
    for (const ClipVertex<T, K>& v : polygon) {
      if (!(T(0) < v.position[3])) return;
    }
    cvv::divide_and_cut<AttributeInterpolation::perspective>(volume, planes_of(volume), polygon,
                                                             out);
    clear_if_overflowed(out);
  }
};

}  // namespace clipscope

// SPDX-License-Identifier: MIT
//
// Sutherland-Hodgman in view space, before the projection, against the six frustum planes.
//
// The planes are the unnormalised forms n x + l z and their kin, which need no square root, so that
// every scalar can compute them. Outcodes accept, reject and choose the planes. What is left is
// projected and divided.
// Source: Sutherland and Hodgman, "Reentrant Polygon Clipping", CACM 17(1), 1974.
// Does not guarantee: NDC coordinates within [-1, 1]: a new vertex lies on its plane in view space up
// to rounding, and is rounded again by the projection and the divide.
#pragma once

#include <utility>

#include "spaces/clipper.hpp"
#include "spaces/cut.hpp"
#include "spaces/planes.hpp"

namespace clipscope {

struct ViewSutherlandHodgman {
  static constexpr std::string_view name = "view/sutherland_hodgman";
  static constexpr std::string_view summary =
      "Sutherland-Hodgman in view space against unnormalised frustum planes, then project and "
      "divide";
  static constexpr std::string_view source =
      "Sutherland and Hodgman, Reentrant Polygon Clipping, 1974";
  static constexpr Promise promise{.ulps = kChainUlps};

  template <Scalar T, int K>
  constexpr void operator()(const Projection<T>& projection, const ViewTriangle<T, K>& triangle,
                            NdcPolygon<T, K>& out) const {
    const Frustum<T>& frustum = projection.frustum;
    const TriangleOutcode code = combine(view_outcode(frustum, triangle[0].position),
                                         view_outcode(frustum, triangle[1].position),
                                         view_outcode(frustum, triangle[2].position));
    out.clear();
    if (code.all != 0) {
      return;
    }
    if (code.any == 0) {
      for (const ViewVertex<T, K>& v : triangle) {
        out.push_back(to_ndc(to_clip(projection, v)));
      }
      return;
    }
    cut_planes(projection, triangle, code.any, out);
  }

 private:
  template <Scalar T, int K>
  static constexpr void cut_planes(const Projection<T>& projection,
                                   const ViewTriangle<T, K>& triangle, Outcode planes,
                                   NdcPolygon<T, K>& out) {
    ViewPolygon<T, K> a, b;
    ViewPolygon<T, K>* in = &a;
    ViewPolygon<T, K>* next = &b;
    in->assign(triangle);
    for (const Plane plane : kAllPlanes) {
      if ((planes & bit(plane)) == 0) {
        continue;
      }
      cut(*in, *next, [&](const ViewVertex<T, K>& v) {
        return view_distance(projection.frustum, plane, v.position);
      });
      std::swap(in, next);
    }
    for (const ViewVertex<T, K>& v : *in) {
      const ClipVertex<T, K> clip = to_clip(projection, v);
      if (T(0) < clip.position[3]) {
        out.push_back(to_ndc(clip));
      }
    }
    out.drop_if_degenerate();
  }
};

}  // namespace clipscope

// SPDX-License-Identifier: MIT
//
// Sutherland-Hodgman in homogeneous clip space, before the divide, driven by outcodes.
//
// Outcodes accept what is inside and reject what is outside one plane without computing anything; the
// rest is cut by just the planes that some vertex is outside of, near plane first. Fixed arrays.
// Source: Sutherland and Hodgman, "Reentrant Polygon Clipping", CACM 17(1), 1974; outcodes: Cohen and
// Sutherland, in Newman and Sproull, "Principles of Interactive Computer Graphics", 1973; homogeneous:
// Blinn and Newell, "Clipping Using Homogeneous Coordinates", SIGGRAPH 1978.
// Does not guarantee: coordinates within the volume to the last bit after the divide; the exact
// vertex count where a vertex comes within rounding of a plane.
#pragma once

#include <utility>

#include "spaces/clipper.hpp"
#include "spaces/cut.hpp"
#include "spaces/homogeneous/divide.hpp"
#include "spaces/planes.hpp"

namespace clipscope {

struct HomogeneousSutherlandHodgman {
  static constexpr std::string_view name = "homogeneous/sutherland_hodgman";
  static constexpr std::string_view summary =
      "Sutherland-Hodgman in clip space; outcodes accept, reject and choose the planes; near first";
  static constexpr std::string_view source =
      "Blinn and Newell, Clipping Using Homogeneous Coordinates, 1978";
  static constexpr Promise promise{.ulps = kChainUlps};

  template <Scalar T, int K>
  constexpr void operator()(const Projection<T>& projection, const ViewTriangle<T, K>& triangle,
                            NdcPolygon<T, K>& out) const {
    clip(projection.frustum.depth,
         {to_clip(projection, triangle[0].position), to_clip(projection, triangle[1].position),
          to_clip(projection, triangle[2].position)},
         triangle, out);
  }

  template <Scalar T, int K>
  constexpr void operator()(DepthRange depth, const ClipTriangle<T, K>& triangle,
                            NdcPolygon<T, K>& out) const {
    clip(depth, {triangle[0].position, triangle[1].position, triangle[2].position}, triangle, out);
  }

 private:
  static constexpr std::array<Plane, kPlanes> kOrder = {Plane::near,  Plane::far,    Plane::left,
                                                        Plane::right, Plane::bottom, Plane::top};

  // `source` gives the attributes: they are not copied before they are needed.
  template <Scalar T, Space S, int K>
  static constexpr void clip(DepthRange depth, const std::array<Vec4<T>, 3>& positions,
                             const Triangle<S, T, K>& source, NdcPolygon<T, K>& out) {
    const TriangleOutcode code =
        combine(clip_outcode(depth, positions[0]), clip_outcode(depth, positions[1]),
                clip_outcode(depth, positions[2]));
    out.clear();
    if (code.all != 0) {
      return;
    }
    if (code.any == 0) {
      divide_inside(positions, source, out);
      return;
    }
    const ClipTriangle<T, K> triangle = {ClipVertex<T, K>{positions[0], source[0].attributes},
                                         ClipVertex<T, K>{positions[1], source[1].attributes},
                                         ClipVertex<T, K>{positions[2], source[2].attributes}};
    cut_planes(depth, triangle, code.any, out);
  }

  // A vertex inside all planes has w >= |x| >= 0; only (0, 0, 0, 0) has w = 0, and is outside.
  template <Scalar T, Space S, int K>
  static constexpr void divide_inside(const std::array<Vec4<T>, 3>& positions,
                                      const Triangle<S, T, K>& source, NdcPolygon<T, K>& out) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(T(0) < positions[i][3])) {
        out.clear();
        return;
      }
      out.push_back({to_ndc(positions[i]), source[i].attributes});
    }
  }

  template <Scalar T, int K>
  static constexpr void cut_planes(DepthRange depth, const ClipTriangle<T, K>& triangle,
                                   Outcode planes, NdcPolygon<T, K>& out) {
    ClipPolygon<T, K> a, b;
    ClipPolygon<T, K>* in = &a;
    ClipPolygon<T, K>* next = &b;
    in->assign(triangle);
    for (const Plane plane : kOrder) {
      if ((planes & bit(plane)) == 0) {
        continue;
      }
      cut(*in, *next,
          [&](const ClipVertex<T, K>& v) { return clip_distance(depth, plane, v.position); });
      std::swap(in, next);
    }
    divide(*in, out);
  }
};

}  // namespace clipscope

// SPDX-License-Identifier: MIT
//
// Sutherland-Hodgman in view space, before the projection, against the six frustum planes.
//
// Outcodes accept, reject and choose the planes. What is left is projected and divided. The policy
// is how a distance to a plane is computed:
//
//   view/sutherland_hodgman  the unnormalised forms n x + l z and their kin: two products, no
//                            square root, so that every scalar can compute them
//   view/exact_sign          the same forms from exact products, so that the input's vertices are
//                            always on the right side of the side planes of a perspective frustum
//   view/unit_normals        planes with normals of length 1, the way textbooks have them; for
//                            scalars with a square root
//
// Source: Sutherland and Hodgman, "Reentrant Polygon Clipping", CACM 17(1), 1974.
// Guarantees: the vertices on an edge depend on that edge alone, bit for bit (spaces/measured.hpp).
// Does not guarantee: NDC coordinates within [-1, 1]: a new vertex lies on its plane in view space
// up to rounding, and is rounded again by the projection and the divide. The unit normals are
// rounded, and then the planes of the volume are not quite those of the projection.
#pragma once

#include "spaces/clipper.hpp"
#include "spaces/cut.hpp"
#include "spaces/measured.hpp"
#include "spaces/view/plane_form.hpp"

namespace clipscope {

template <PlaneForm kForm>
struct ViewSutherlandHodgmanWith {
  static constexpr std::string_view name = kForm == PlaneForm::unnormalised
                                               ? "view/sutherland_hodgman"
                                           : kForm == PlaneForm::exact_sign ? "view/exact_sign"
                                                                            : "view/unit_normals";
  static constexpr std::string_view summary =
      kForm == PlaneForm::unnormalised
          ? "Sutherland-Hodgman in view space against unnormalised planes, then project and divide"
      : kForm == PlaneForm::exact_sign
          ? "the same with plane distances from exact products, hence of the right sign"
          : "the same against planes with unit normals";
  static constexpr std::string_view source =
      "Sutherland and Hodgman, Reentrant Polygon Clipping, 1974";
  // A unit normal has three roundings more than the form without.
  static constexpr Promise promise{
      .ulps = kForm == PlaneForm::unit_normals ? kChainUlps + kPlanes * 4 : kChainUlps,
      .watertight = true};

  template <Scalar T, int K>
  requires kPlaneFormExistsIn<kForm, T>
  constexpr void operator()(const Projection<T>& projection, const ViewTriangle<T, K>& triangle,
                            NdcPolygon<T, K>& out) const {
    const OutcodeSummary code = outcodes(projection, triangle);
    out.clear();
    if (code.all != 0 || is_beyond_open_side(projection, triangle)) return;
    if (code.any == 0) {
      project(projection, triangle, out);
    } else if (has_finite_positions(triangle)) {
      cut_and_then(projection, code.any, triangle,
                   [&](const auto& rest) { project(projection, rest, out); });
    }
  }

  template <Scalar T, int K>
  requires kPlaneFormExistsIn<kForm, T>
  static constexpr ViewPolygon<T, K> cut(const Projection<T>& projection,
                                         const ViewTriangle<T, K>& triangle) {
    const OutcodeSummary code = outcodes(projection, triangle);
    ViewPolygon<T, K> out;
    if (code.all != 0 || is_beyond_open_side(projection, triangle)) return out;
    if (!has_finite_positions(triangle)) return out;
    cut_and_then(projection, code.any, triangle, [&](const auto& rest) {
      for (const ViewVertex<T, K>& v : rest) out.push_back(v);
    });
    bool finite = true;
    for (const ViewVertex<T, K>& v : out) finite = finite && has_finite_position(v);
    if (!finite) out.clear();
    out.drop_if_degenerate();
    return out;
  }

 private:
  template <Scalar T, int K>
  static constexpr OutcodeSummary outcodes(const Projection<T>& projection,
                                           const ViewTriangle<T, K>& triangle) {
    return summarize_outcodes(projection.volume, triangle, [&](std::size_t i) {
      return position_outcode(projection, triangle[i].position);
    });
  }

  template <Scalar T>
  static constexpr Outcode position_outcode(const Projection<T>& projection, const Vec3<T>& v) {
    Outcode code = 0;
    for (const Plane plane : kAllPlanes) {
      if (!(T(0) <= view_distance<kForm>(projection, plane, v))) code |= bit(plane);
    }
    return code;
  }

  template <Scalar T, int K>
  static constexpr bool is_beyond_open_side(const Projection<T>& projection,
                                            const ViewTriangle<T, K>& triangle) {
    return clipscope::is_beyond_open_side(projection.volume, 3, [&](Plane side, std::size_t i) {
      return T(0) < view_distance<kForm>(projection, side, triangle[i].position);
    });
  }

  // f(rest): what is left of a triangle inside of the planes of the code. Distances are carried
  // only where they are asked of a new vertex.
  template <Scalar T, int K, class F>
  static constexpr void cut_and_then(const Projection<T>& projection, Outcode planes,
                                     const ViewTriangle<T, K>& triangle, F&& f) {
    const auto distance = [&](Plane plane, const ViewVertex<T, K>& v) {
      return signed_distance<kForm>(projection, plane, v);
    };
    if (is_single(planes)) {
      ViewPolygon<T, K> polygon, scratch;
      polygon.assign(triangle);
      return f(cut_by_planes(polygon, scratch, planes, kAllPlanes, distance));
    }
    MeasuredPolygon<Space::view, T, K> polygon, scratch;
    for (const ViewVertex<T, K>& v : triangle) polygon.push_back(measured(v, planes, distance));
    f(cut_by_planes(polygon, scratch, planes, kAllPlanes, carried_distance<Space::view, T, K>));
  }

  template <Scalar T, int K, class Vertices>
  static constexpr void project(const Projection<T>& projection, const Vertices& vertices,
                                NdcPolygon<T, K>& out) {
    for (const ViewVertex<T, K>& v : vertices) {
      const ClipVertex<T, K> clip = to_clip(projection, v);
      if (T(0) < clip.position[3] && is_finite(clip.position[3])) out.push_back(to_ndc(clip));
    }
    out.drop_if_degenerate();
    clear_if_overflowed(out);
  }
};

using ViewSutherlandHodgman = ViewSutherlandHodgmanWith<PlaneForm::unnormalised>;
using ViewExactSign = ViewSutherlandHodgmanWith<PlaneForm::exact_sign>;
using ViewUnitNormals = ViewSutherlandHodgmanWith<PlaneForm::unit_normals>;

}  // namespace clipscope

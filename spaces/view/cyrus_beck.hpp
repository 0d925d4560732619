// SPDX-License-Identifier: MIT
//
// Cyrus-Beck for segments in view space, against the frustum planes, before the projection.
//
// Every plane of a convex volume gives the parameter where the segment's line crosses it; the
// largest of those where it enters and the smallest of those where it leaves bound what is visible.
// All planes are visited and divided for; whether anything is visible is asked once, at the end.
// The policy is how the planes are had:
//
//   view/cyrus_beck               unnormalised forms, from the frustum's numbers at each use
//   view/cyrus_beck_unit_normals  equations with normals of length 1, computed once per view: as
//                                 the paper has them; for scalars with a square root
//
// Source: Cyrus and Beck, "Generalized Two- and Three-Dimensional Clipping", Computers & Graphics
// 3(1), 1978.
// Guarantees: a segment and its reverse give the same bits: parameters are measured from the end
// that is kept.
// Does not guarantee: NDC coordinates within [-1, 1]: a new end lies on its plane in view
// space up to rounding, and is rounded again by the projection and the divide.
#pragma once

#include "spaces/segment.hpp"
#include "spaces/view/plane_form.hpp"

namespace clipscope {

template <PlaneForm kForm>
struct ViewCyrusBeckWith {
  static constexpr bool kUnit = kForm == PlaneForm::unit_normals;
  static constexpr std::string_view name =
      kUnit ? "view/cyrus_beck_unit_normals" : "view/cyrus_beck";
  static constexpr std::string_view summary =
      kUnit ? "the same against planes with unit normals, computed once per view"
            : "Cyrus-Beck in view space against the frustum planes, then project and divide";
  static constexpr std::string_view source =
      "Cyrus and Beck, Generalized Two- and Three-Dimensional Clipping, 1978";
  // A unit normal has three roundings more than the form without, for the plane that cuts and for
  // the one that may be taken in its place.
  static constexpr Promise promise{.ulps = kProjectUlps + kParametricUlps + (kUnit ? 2 * 4 : 0),
                                   .watertight = true};

  template <Scalar T, int K>
  requires kPlaneFormExistsIn<kForm, T>
  constexpr void operator()(const Projection<T>& projection, const ViewSegment<T, K>& segment,
                            NdcPolygon<T, K>& out) const {
    out.clear();
    const auto is_inside = [&](Plane side, std::size_t i) {
      return T(0) < signed_distance<kForm>(projection, side, segment[i]);
    };
    if (is_beyond_open_side(projection.volume, 2, is_inside)) return;
    const Parameters<T> kept = parameters(projection, segment);
    if (!kept.visible()) return;
    ViewSegment<T, K> ends = segment;
    if (kept.of_first < T(1)) ends[0] = interpolate(segment[1], segment[0], kept.of_first);
    if (kept.of_second < T(1)) ends[1] = interpolate(segment[0], segment[1], kept.of_second);
    divide(to_clip(projection, ends), out);
  }

 private:
  // How far each end may be from the other one, in lengths of the segment.
  template <class T>
  struct Parameters {
    T of_first = T(1), of_second = T(1);
    bool outside_parallel = false;  // outside a plane that the segment is parallel to

    // Where one end stays the order can't be wrong, and 1 + t would lose a small t.
    constexpr bool visible() const {
      if (outside_parallel || !(T(0) < of_first) || !(T(0) < of_second)) return false;
      return !(of_first < T(1)) || !(of_second < T(1)) || T(1) < of_first + of_second;
    }
  };

  template <Scalar T, int K>
  static constexpr Parameters<T> parameters(const Projection<T>& projection,
                                            const ViewSegment<T, K>& segment) {
    Parameters<T> kept;
    for_each_plane(planes_of(projection.volume), kAllPlanes, [&](Plane plane) {
      const T d_first = signed_distance<kForm>(projection, plane, segment[0]);
      const T d_second = signed_distance<kForm>(projection, plane, segment[1]);
      if (d_first < d_second) {
        tighten(kept.of_first, cut_parameter(d_second, d_first));
      } else if (d_second < d_first) {
        tighten(kept.of_second, cut_parameter(d_first, d_second));
      } else if (!(T(0) <= d_first && T(0) <= d_second)) {
        kept.outside_parallel = true;
      }
    });
    return kept;
  }

  // A NaN, from distances that overflow, counts as nothing kept.
  template <class T>
  static constexpr void tighten(T& kept, const T& t) {
    if (!(kept <= t)) kept = larger(T(0), t);
  }
};

using ViewCyrusBeck = ViewCyrusBeckWith<PlaneForm::unnormalised>;
using ViewCyrusBeckUnitNormals = ViewCyrusBeckWith<PlaneForm::unit_normals>;

}  // namespace clipscope

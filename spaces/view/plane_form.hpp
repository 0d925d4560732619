// SPDX-License-Identifier: MIT
//
// The forms in which a frustum's planes can be had in view space.
//
//   unnormalised  n x + l z and its kin, from the frustum's numbers at each use: two products
//   exact_sign    the same from exact products: the sign of a side plane's distance is exact
//   unit_normals  a x + b y + c z + d with a normal of length 1, computed once per view; in scalars
//                 with a square root
//
// Does not guarantee: that planes with unit normals are quite those of the projection: the normals
// are rounded.
#pragma once

#include "spaces/planes.hpp"
#include "spaces/products.hpp"

namespace clipscope {

enum class PlaneForm { unnormalised, exact_sign, unit_normals };

template <PlaneForm kForm, class T>
inline constexpr bool kPlaneFormExistsIn = kForm == PlaneForm::unit_normals ? HasSquareRoot<T>
                                           : kForm == PlaneForm::exact_sign ? HasSumOfProducts<T>
                                                                            : true;

// Signed distance form of one of the six planes.
template <PlaneForm kForm, Scalar T>
constexpr T view_distance(const Projection<T>& projection, Plane plane, const Vec3<T>& v) {
  if constexpr (kForm == PlaneForm::exact_sign) {
    return exact_sign_view_distance(projection.frustum, plane, v);
  } else if constexpr (kForm == PlaneForm::unit_normals) {
    return user_plane_distance(projection.unit_planes[static_cast<std::size_t>(plane)], v);
  } else {
    return view_distance(projection.frustum, plane, v);
  }
}

// The same for a vertex and any plane of the volume, clip distances included.
template <PlaneForm kForm, Scalar T, int K>
constexpr T signed_distance(const Projection<T>& projection, Plane plane,
                            const ViewVertex<T, K>& v) {
  if (is_clip_distance(plane)) return v.attributes[clip_distance_index(plane)];
  return view_distance<kForm>(projection, plane, v.position);
}

}  // namespace clipscope

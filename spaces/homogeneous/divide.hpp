// SPDX-License-Identifier: MIT
//
// The perspective divide of a clipped polygon: the last step of every homogeneous clipper.
#pragma once

#include "spaces/polygon.hpp"
#include "spaces/projection.hpp"

namespace clipscope {

// Divides every vertex of a list by its w into `out`. After clipping exactly, w is positive or the
// vertex is (0, 0, 0, 0), which is outside by definition: where w is not positive it is left out.
template <class Vertices, Scalar T, int K>
constexpr void divide(const Vertices& in, NdcPolygon<T, K>& out) {
  out.clear();
  for (const ClipVertex<T, K>& v : in) {
    if (T(0) < v.position[3]) out.push_back(to_ndc(v));
  }
  out.drop_if_degenerate();
  clear_if_overflowed(out);
}

// Writes to `out` what `divide` takes of a list, before it divides: the vertices with w > 0.
// Nothing if they are fewer than three or one is not finite.
template <class Vertices, Scalar T, int K>
constexpr void take_divisible(const Vertices& in, ClipPolygon<T, K>& out) {
  out.clear();
  bool finite = true;
  for (const ClipVertex<T, K>& v : in) {
    if (!(T(0) < v.position[3])) continue;
    finite = finite && has_finite_position(v);
    out.push_back(v);
  }
  if (!finite) out.clear();
  out.drop_if_degenerate();
}

template <Scalar T, int K, class Vertices>
constexpr ClipPolygon<T, K> divisible(const Vertices& in) {
  ClipPolygon<T, K> out;
  take_divisible(in, out);
  return out;
}

// Divides a triangle that is inside all planes into `out`: a vertex has w >= |x| >= 0 then; only
// (0, 0, 0, 0) has w = 0, and is outside. With depth clamp nothing bounds z. `source` gives the
// attributes.
template <Scalar T, Space S, int K>
constexpr void divide_inside(const ClipVolume& volume, const std::array<Vec4<T>, 3>& positions,
                             const Triangle<S, T, K>& source, NdcPolygon<T, K>& out) {
  out.clear();
  for (std::size_t i = 0; i < 3; ++i) {
    const T& w = positions[i][3];
    if (!(T(0) < w) || !is_finite(w)) {
      out.clear();
      return;
    }
    const Vec4<T> ndc = to_ndc(positions[i]);
    if (volume.depth_clamp && !is_finite(ndc[2])) {
      out.clear();
      return;
    }
    out.push_back({ndc, source[i].attributes});
  }
}

}  // namespace clipscope

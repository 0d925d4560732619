// SPDX-License-Identifier: MIT
//
// The perspective divide of a clipped polygon: the last step of every homogeneous clipper.
#pragma once

#include "spaces/polygon.hpp"
#include "spaces/projection.hpp"

namespace clipscope {

// Divides every vertex by its w into `out`. After clipping exactly, w is positive or the vertex is
// (0, 0, 0, 0), which is outside by definition; a vertex whose w is not positive is left out.
template <Scalar T, int K>
constexpr void divide(const ClipPolygon<T, K>& in, NdcPolygon<T, K>& out) {
  out.clear();
  for (const ClipVertex<T, K>& v : in) {
    if (T(0) < v.position[3]) {
      out.push_back(to_ndc(v));
    }
  }
  out.drop_if_degenerate();
}

}  // namespace clipscope

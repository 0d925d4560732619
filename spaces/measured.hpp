// SPDX-License-Identifier: MIT
//
// Vertices that carry their signed distances to the six planes of the volume.
//
// A new vertex gets its distances by the same interpolation as its coordinates, so that no decision
// is taken on a rounded position: a polygon that reaches into the volume by less than the rounding
// of its new vertices is still there. A clip distance is an attribute, hence carried anyway.
// Source: Blinn and Newell, "Clipping Using Homogeneous Coordinates", SIGGRAPH 1978, whose boundary
// coordinates these are.
// Guarantees: the vertices on an edge depend on that edge alone, bit for bit: a distance
// interpolated between two that are >= 0 is >= 0 (rounding is monotone), so a plane that both ends
// of an edge are inside of never touches what lies between them, whichever planes the neighbour is
// cut by.
// Its bound, in units of u M (spaces/clipper.hpp): a cut makes a coordinate, a + t (b - a) with
// t <= 1/2, by three roundings of 1 each, and a distance, up to 2 M, by three of 2. Errors of the
// ends are averaged, so that after k cuts a vertex is off by 3 k from the point of the triangle
// that its t's say, and a distance by 6 k from that of the point. The two roundings of t move a
// distance by 4. So a vertex is at most 3 k from a point that is outside of a plane by at most
// 6 k + 4, and 9 k + 4 with k <= 6 is less than kChainUlps allows.
// Does not guarantee: that the distance of a new vertex is that of its rounded position.
#pragma once

#include <array>

#include "spaces/planes.hpp"
#include "spaces/polygon.hpp"

namespace clipscope {

template <Space S, Scalar T, int K>
struct MeasuredVertex : Vertex<S, T, K> {
  // By Plane; two more than there are, which makes whole vectors.
  std::array<T, 8> distances;
};

template <Space S, Scalar T, int K>
using MeasuredPolygon = VertexList<MeasuredVertex<S, T, K>>;

// With distances to the planes of the code; distance(plane, v) is the signed distance.
template <Space S, Scalar T, int K, class Distance>
constexpr MeasuredVertex<S, T, K> measured(const Vertex<S, T, K>& v, Outcode planes,
                                           Distance&& distance) {
  MeasuredVertex<S, T, K> r{v, {}};
  for (const Plane plane : kAllPlanes) {
    if ((planes & bit(plane)) != 0) {
      r.distances[static_cast<std::size_t>(plane)] = distance(plane, v);
    }
  }
  return r;
}

// With distances to all planes.
template <Scalar T, int K>
constexpr MeasuredVertex<Space::clip, T, K> measured(DepthRange depth, const ClipVertex<T, K>& v) {
  const auto d = [&](Plane plane) { return clip_distance(depth, plane, v.position); };
  return {v,
          {d(Plane::left), d(Plane::right), d(Plane::bottom), d(Plane::top), d(Plane::near),
           d(Plane::far), T(0), T(0)}};
}

// The distance that the vertex carries, to any plane of the volume.
template <Space S, Scalar T, int K>
constexpr T carried_distance(Plane plane, const MeasuredVertex<S, T, K>& v) {
  if (is_clip_distance(plane)) return v.attributes[clip_distance_index(plane)];
  return v.distances[static_cast<std::size_t>(plane)];
}

// The same by the name that vertices without distances have for it.
template <Scalar T, int K>
constexpr T signed_distance(DepthRange, Plane plane, const MeasuredVertex<Space::clip, T, K>& v) {
  return carried_distance(plane, v);
}

// a + t (b - a), distances included.
template <Space S, Scalar T, int K>
constexpr MeasuredVertex<S, T, K> interpolate(const MeasuredVertex<S, T, K>& a,
                                              const MeasuredVertex<S, T, K>& b, const T& t) {
  MeasuredVertex<S, T, K> r;
  interpolate_into(r, a, b, t);
  for (std::size_t p = 0; p < r.distances.size(); ++p) {
    r.distances[p] = a.distances[p] + t * (b.distances[p] - a.distances[p]);
  }
  return r;
}

}  // namespace clipscope

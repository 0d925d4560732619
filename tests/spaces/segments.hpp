// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segments for tests, and what is exactly visible of them: the interval of their parameter.
#pragma once

#include <optional>

#include "spaces/plane_segment.hpp"
#include "tests/spaces/triangles.hpp"

namespace clipscope::tests {

using Ends = std::array<std::array<double, 4>, 2>;

// Attribute 0 is 1 at the first end and 0 at the second, attribute 1 the other way round; attribute
// 2 is 2 and -1, unless given.
template <Scalar T>
ClipSegment<T, K> clip_segment(const Ends& ends, const std::array<double, 2>& attribute = {2, -1}) {
  using experiments::scalar_from;
  ClipSegment<T, K> segment;
  for (std::size_t i = 0; i < 2; ++i) {
    for (int c = 0; c < 4; ++c) {
      segment[i].position[c] = scalar_from<T>(ends[i][static_cast<std::size_t>(c)]);
    }
    segment[i].attributes.values = {T(i == 0 ? 1 : 0), T(i == 0 ? 0 : 1),
                                    scalar_from<T>(attribute[i])};
  }
  return segment;
}

template <Scalar T>
ViewSegment<T, K> view_segment(const Ends& ends) {
  const ClipSegment<T, K> clip = clip_segment<T>(ends);
  ViewSegment<T, K> segment;
  for (std::size_t i = 0; i < 2; ++i) {
    segment[i].position = Vec3<T>(clip[i].position[0], clip[i].position[1], clip[i].position[2]);
    segment[i].attributes = clip[i].attributes;
  }
  return segment;
}

inline Ends lattice_ends(std::mt19937_64& random) {
  const Corners corners = lattice_corners(random);
  return {corners[0], corners[1]};
}

inline Ends random_ends(std::mt19937_64& random, double size) {
  const Corners corners = random_corners(random, size);
  return {corners[0], corners[1]};
}

template <class S>
S reversed(const S& segment) {
  return {segment[1], segment[0]};
}

// The parameters, from the first end, between which every distance is at least `margin`; none if
// that leaves a point at most.
template <class N>
struct Interval {
  N from = N(0), to = N(1);
};

// distances(plane) gives those of both ends.
template <class N, class Distances>
std::optional<Interval<N>> visible_interval(Outcode planes, const N& margin,
                                            Distances&& distances) {
  Interval<N> r;
  bool visible = true;
  for_each_plane(planes, kAllPlanes, [&](Plane plane) {
    const std::array<N, 2> d = distances(plane);
    const N a = d[0] - margin;
    const N b = d[1] - margin;
    if (a < N(0) && b < N(0)) visible = false;
    if (a < N(0) && !(b < N(0))) {
      const N at = a / (a - b);
      if (r.from < at) r.from = at;
    }
    if (b < N(0) && !(a < N(0))) {
      const N at = a / (a - b);
      if (at < r.to) r.to = at;
    }
  });
  if (!visible || !(r.from < r.to)) return std::nullopt;
  return r;
}

}  // namespace clipscope::tests

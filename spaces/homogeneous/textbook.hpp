// SPDX-License-Identifier: MIT
//
// The baseline: Sutherland-Hodgman in clip space the way tutorials write it.
//
// Six plane vectors, dot products for every edge and plane, a dynamic array that is copied at each
// plane, no outcodes, edges interpolated in the order in which they are walked.
// Source: Sutherland and Hodgman, "Reentrant Polygon Clipping", CACM 17(1), 1974, in homogeneous
// coordinates: Blinn and Newell, "Clipping Using Homogeneous Coordinates", SIGGRAPH 1978.
// Does not guarantee: equal bits on shared edges (the two neighbours walk them in opposite
// directions).
#pragma once

#include <array>
#include <vector>

#include "spaces/clipper.hpp"
#include "spaces/homogeneous/divide.hpp"
#include "spaces/planes.hpp"

namespace clipscope {

struct Textbook : StartsInClipSpace<Textbook> {
  static constexpr std::string_view name = "textbook";
  static constexpr std::string_view summary =
      "Sutherland-Hodgman over six plane vectors, dynamic arrays copied at each plane (the baseline)";
  static constexpr std::string_view source =
      "Sutherland and Hodgman, Reentrant Polygon Clipping, 1974";
  // A clip distance is a seventh plane and so on; it has no plane vector.
  static constexpr Promise promise{.ulps = kChainUlps};

  template <Scalar T, int K>
  static void clip(const ClipVolume& volume, const ClipTriangle<T, K>& triangle,
                   NdcPolygon<T, K>& out) {
    divide(cut_planes(volume, triangle), out);
  }

  template <Scalar T, int K>
  static ClipPolygon<T, K> cut(const ClipVolume& volume, const ClipTriangle<T, K>& triangle) {
    if (is_beyond_open_side(volume, triangle)) return {};
    return divisible<T, K>(cut_planes(volume, triangle));
  }

 private:
  // Maybe fewer than three vertices, some with w = 0; nothing of a triangle that is not finite.
  template <Scalar T, int K>
  static std::vector<ClipVertex<T, K>> cut_planes(const ClipVolume& volume,
                                                  const ClipTriangle<T, K>& triangle) {
    if (!has_finite_positions(triangle)) return {};
    std::vector<ClipVertex<T, K>> polygon(triangle.begin(), triangle.end());
    const std::array<Vec4<T>, kPlanes> planes = plane_vectors<T>(volume.depth);
    for_each_plane(planes_of(volume), kAllPlanes, [&](Plane plane) {
      const std::vector<ClipVertex<T, K>> input = polygon;
      if (is_clip_distance(plane)) {
        const int i = clip_distance_index(plane);
        clip_against([i](const ClipVertex<T, K>& v) { return v.attributes[i]; }, input, polygon);
      } else {
        const Vec4<T>& n = planes[static_cast<std::size_t>(plane)];
        clip_against([&n](const ClipVertex<T, K>& v) { return dot(n, v.position); }, input,
                     polygon);
      }
    });
    return polygon;
  }

  // In the order of Plane.
  template <Scalar T>
  static std::array<Vec4<T>, kPlanes> plane_vectors(DepthRange depth) {
    const T o(0), i(1), m(-1);
    const bool reversed = depth == DepthRange::reversed;
    const Vec4<T> low(o, o, i, T(depth == DepthRange::minus_one_to_one ? 1 : 0)), high(o, o, m, i);
    return {Vec4<T>(i, o, o, i), Vec4<T>(m, o, o, i),   Vec4<T>(o, i, o, i),
            Vec4<T>(o, m, o, i), reversed ? high : low, reversed ? low : high};
  }

  template <Scalar T>
  static T dot(const Vec4<T>& a, const Vec4<T>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  }

  template <class Distance, Scalar T, int K>
  static void clip_against(Distance&& distance, const std::vector<ClipVertex<T, K>>& input,
                           std::vector<ClipVertex<T, K>>& output) {
    output.clear();
    for (std::size_t i = 0; i < input.size(); ++i) {
      const ClipVertex<T, K>& current = input[i];
      const ClipVertex<T, K>& next = input[(i + 1) % input.size()];
      const T d_current = distance(current);
      const T d_next = distance(next);
      const bool current_inside = T(0) <= d_current;
      const bool next_inside = T(0) <= d_next;
      if (current_inside) output.push_back(current);
      if (current_inside != next_inside) {
        const T t = d_current / (d_current - d_next);
        output.push_back(interpolate(current, next, t));
      }
    }
  }
};

}  // namespace clipscope

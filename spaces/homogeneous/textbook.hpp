// SPDX-License-Identifier: MIT
//
// The baseline: Sutherland-Hodgman in clip space the way tutorials write it.
//
// Six plane vectors, a dot product per vertex and plane, a dynamic array that is made anew and copied
// at each plane, no outcodes, edges interpolated in the order in which they are walked.
// Source: Sutherland and Hodgman, "Reentrant Polygon Clipping", CACM 17(1), 1974, in homogeneous
// coordinates: Blinn and Newell, "Clipping Using Homogeneous Coordinates", SIGGRAPH 1978.
// Does not guarantee: equal bits on shared edges (the two neighbours walk them in opposite directions).
#pragma once

#include <vector>

#include "spaces/clipper.hpp"
#include "spaces/planes.hpp"

namespace clipscope {

struct Textbook {
  static constexpr std::string_view name = "textbook";
  static constexpr std::string_view summary =
      "Sutherland-Hodgman over six plane vectors, dynamic arrays copied at each plane (the "
      "baseline)";
  static constexpr std::string_view source =
      "Sutherland and Hodgman, Reentrant Polygon Clipping, 1974";
  static constexpr Promise promise{.ulps = 64};

  template <Scalar T, int K>
  void operator()(const Projection<T>& projection, const ViewTriangle<T, K>& triangle,
                  NdcPolygon<T, K>& out) const {
    (*this)(projection.frustum.depth, to_clip(projection, triangle), out);
  }

  template <Scalar T, int K>
  void operator()(DepthRange depth, const ClipTriangle<T, K>& triangle,
                  NdcPolygon<T, K>& out) const {
    std::vector<ClipVertex<T, K>> polygon(triangle.begin(), triangle.end());
    for (const Vec4<T>& plane : plane_vectors<T>(depth)) {
      polygon = clip_against(plane, polygon);
    }
    out.clear();
    for (const ClipVertex<T, K>& v : polygon) {
      if (T(0) < v.position[3]) {
        out.push_back(to_ndc(v));
      }
    }
    out.drop_if_degenerate();
  }

 private:
  template <Scalar T>
  static std::vector<Vec4<T>> plane_vectors(DepthRange depth) {
    const T o(0), i(1), m(-1);
    const bool full_range = depth == DepthRange::minus_one_to_one;
    return {{i, o, o, i}, {m, o, o, i}, {o, i, o, i}, {o, m, o, i}, {o, o, i, full_range ? i : o},
            {o, o, m, i}};
  }

  template <Scalar T>
  static T dot(const Vec4<T>& a, const Vec4<T>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  }

  template <Scalar T, int K>
  static std::vector<ClipVertex<T, K>> clip_against(const Vec4<T>& plane,
                                                    std::vector<ClipVertex<T, K>> input) {
    std::vector<ClipVertex<T, K>> output;
    for (std::size_t i = 0; i < input.size(); ++i) {
      const ClipVertex<T, K>& current = input[i];
      const ClipVertex<T, K>& next = input[(i + 1) % input.size()];
      const T d_current = dot(plane, current.position);
      const T d_next = dot(plane, next.position);
      const bool current_inside = T(0) <= d_current;
      const bool next_inside = T(0) <= d_next;
      if (current_inside) {
        output.push_back(current);
      }
      if (current_inside != next_inside) {
        const T t = d_current / (d_current - d_next);
        output.push_back(interpolate(current, next, t));
      }
    }
    return output;
  }
};

}  // namespace clipscope

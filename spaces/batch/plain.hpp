// SPDX-License-Identifier: MIT
//
// The plain twins of the batch clippers: one triangle at a time, clip space in, clip space out, no divide.
//
// They are made of the scalar clippers' own parts and say what the SIMD code has to answer, bit for bit; and
// they clip what it hands back (clip distances, depth clamp, vertices that aren't finite, polygons that
// rounding has made other than convex).
#pragma once

#include "spaces/barycentric/correctly_rounded.hpp"
#include "spaces/batch/batch.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"

namespace clipscope::batch {

template <std::floating_point To, std::floating_point From, int K>
ClipVertex<To, K> vertex_cast(const ClipVertex<From, K>& v) {
  ClipVertex<To, K> r;
  for (int c = 0; c < 4; ++c) r.position[c] = static_cast<To>(v.position[c]);
  r.attributes.resize(v.attributes.size());
  for (int k = 0; k < v.attributes.size(); ++k) {
    r.attributes[k] = static_cast<To>(v.attributes[k]);
  }
  return r;
}

// Sutherland-Hodgman in T, rounded to float once at the end.
template <std::floating_point T, int K>
void clip_homogeneous(const ClipVolume& volume, const ClipTriangle<float, K>& triangle,
                      ClipPolygon<float, K>& out) {
  out.clear();
  const OutcodeSummary code = summarize_outcodes(volume, triangle, [&](std::size_t i) {
    return clip_outcode(volume.depth, triangle[i].position);
  });
  if (code.all != 0) return;
  ClipPolygon<T, K> polygon, scratch;
  for (const ClipVertex<float, K>& v : triangle) polygon.push_back(vertex_cast<T>(v));
  for (const ClipVertex<T, K>& v :
       HomogeneousSutherlandHodgman::cut(volume, code.any, polygon, scratch)) {
    if (T(0) < v.position[3]) out.push_back(vertex_cast<float>(v));
  }
  out.drop_if_degenerate();
  for (const ClipVertex<float, K>& v : out) {
    if (!has_finite_position(v)) {
      out.clear();
      return;
    }
  }
}

// Decisions by the signs of rounded determinants. Used in place of a count of stages: see
// `barycentric::side`.
struct RoundedSigns {};
inline int side(const barycentric::Meeting& m, const barycentric::Line& line, RoundedSigns&) {
  const double d = barycentric::dot(m, line.rounded).value;
  return (d > 0) - (d < 0);
}

// sum lambda_i v_i / sum lambda_i, +0 if it is 0. A vertex without weight takes no part.
inline float weighted_mean(const barycentric::Meeting& m, const std::array<float, 3>& v,
                           double reciprocal) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    if (m.magnitude[i] != 0) sum += m.lambda[i] * static_cast<double>(v[i]);
  }
  return static_cast<float>(sum * reciprocal);
}

// Where the meeting lies on a plane by construction, its coordinate or clip distance is set.
template <int K>
void set_on_planes(DepthRange depth, const barycentric::Meeting& m, ClipVertex<float, K>& v) {
  for_each_plane(barycentric::planes_of(m), kAllPlanes, [&](Plane plane) {
    if (is_clip_distance(plane)) {
      v.attributes[clip_distance_index(plane)] = 0;
      return;
    }
    const auto [axis, bound] = barycentric::plane_form(depth, plane);
    v.position[axis] = bound == 0 ? 0 : bound * v.position[3];
  });
}

// Every new vertex from the three own ones in double, rounded to float; a coordinate on its plane is set.
template <int K>
void clip_barycentric(const ClipVolume& volume, const ClipTriangle<float, K>& triangle,
                      ClipPolygon<float, K>& out) {
  out.clear();
  barycentric::CutTriangle cut;
  RoundedSigns signs;
  if (!barycentric::cut_clip_triangle(volume, triangle, barycentric::clip_coordinates(triangle),
                                      cut, signs)) {
    return;
  }
  for (const barycentric::Corner& corner : cut.corners) {
    const barycentric::Meeting& m = corner.at;
    const int own = barycentric::own_vertex(m);
    ClipVertex<float, K> v = triangle[std::max(own, 0)];
    if (own < 0) {
      const double reciprocal = 1 / barycentric::dot(m, barycentric::kOnes).value;
      const auto mean = [&](const auto& of) {
        return weighted_mean(m, {of(triangle[0]), of(triangle[1]), of(triangle[2])}, reciprocal);
      };
      for (int c = 0; c < 4; ++c) {
        v.position[c] = mean([c](const ClipVertex<float, K>& p) { return p.position[c]; });
      }
      for (int k = 0; k < v.attributes.size(); ++k) {
        v.attributes[k] = mean([k](const ClipVertex<float, K>& p) { return p.attributes[k]; });
      }
      set_on_planes(volume.depth, m, v);
    }
    if (0 < v.position[3]) out.push_back(v);
  }
  out.drop_if_degenerate();
}

template <int K>
void clip_plain(Method method, const ClipVolume& volume, const ClipTriangle<float, K>& triangle,
                ClipPolygon<float, K>& out) {
  switch (method) {
    case Method::view:
    case Method::homogeneous: return clip_homogeneous<float>(volume, triangle, out);
    case Method::homogeneous_double: return clip_homogeneous<double>(volume, triangle, out);
    case Method::barycentric: return clip_barycentric(volume, triangle, out);
    case Method::correctly_rounded: return CorrectlyRounded::stage(volume, triangle, out);
  }
}

}  // namespace clipscope::batch

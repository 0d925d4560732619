// SPDX-License-Identifier: MIT
//
// What batch methods do with one triangle beyond the scalar clippers, in plain C++.
#pragma once

#include "spaces/barycentric/exact_corners.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"

namespace clipscope::batch::plain {

template <std::floating_point To, Space S, std::floating_point From, int K>
Vertex<S, To, K> vertex_cast(const Vertex<S, From, K>& v) {
  Vertex<S, To, K> r;
  for (int c = 0; c < r.kDimension; ++c) r.position[c] = static_cast<To>(v.position[c]);
  r.attributes.resize(v.attributes.size());
  for (int k = 0; k < v.attributes.size(); ++k) r.attributes[k] = static_cast<To>(v.attributes[k]);
  return r;
}

// Sutherland-Hodgman's stage in double, rounded to float once; nothing where that overflows.
template <int K>
ClipPolygon<float, K> cut_in_double(const ClipVolume& volume,
                                    const ClipTriangle<float, K>& triangle) {
  const OutcodeSummary code = summarize_outcodes(volume, triangle, [&](std::size_t i) {
    return clip_outcode(volume.depth, triangle[i].position);
  });
  if (code.all != 0 || is_beyond_open_side(volume, triangle)) return {};
  ClipTriangle<double, K> wide;
  for (std::size_t i = 0; i < 3; ++i) wide[i] = vertex_cast<double>(triangle[i]);
  ClipPolygon<float, K> out;
  bool finite = true;
  HomogeneousSutherlandHodgman::cut_and_then(volume, code.any, wide, [&](const auto& rest) {
    for (const ClipVertex<double, K>& v : rest) {
      if (!(0 < v.position[3])) continue;
      out.push_back(vertex_cast<float>(v));
      finite = finite && has_finite_position(out[out.size() - 1]);
    }
  });
  if (!finite) out.clear();
  out.drop_if_degenerate();
  return out;
}

// Decisions by the signs of rounded determinants. Used in place of a count of stages: see
// `barycentric::side`.
struct RoundedSigns {};
inline int side(const barycentric::Meeting& m, const barycentric::Line& line, RoundedSigns&) {
  const double d = barycentric::dot(m, line.rounded).value;
  return (d > 0) - (d < 0);
}

// The corners of the part inside, by such signs; whether there are three or more.
template <std::floating_point V, int K>
bool cut_by_rounded_signs(const ClipVolume& volume, const ClipTriangle<V, K>& triangle,
                          barycentric::CutTriangle& cut) {
  if (!has_finite_positions(triangle)) return false;
  const OutcodeSummary code = summarize_outcodes(volume, triangle, [&](std::size_t i) {
    return clip_outcode(volume.depth, triangle[i].position);
  });
  if (code.all != 0 || is_beyond_open_side(volume, triangle)) return false;
  const auto values = [&](auto&& of) {
    return barycentric::Values{of(triangle[0]), of(triangle[1]), of(triangle[2])};
  };
  const auto row_of = [&](Plane plane) {
    if (is_clip_distance(plane)) {
      const int k = clip_distance_index(plane);
      return barycentric::Line{
          values([k](const ClipVertex<V, K>& v) { return v.attributes[k]; }), {}, bit(plane)};
    }
    const barycentric::PlaneForm form = barycentric::plane_form(volume.depth, plane);
    return barycentric::clip_row(
        form, plane, values([&](const ClipVertex<V, K>& v) { return v.position[form.axis]; }),
        values([](const ClipVertex<V, K>& v) { return v.position[3]; }));
  };
  RoundedSigns signs;
  barycentric::cut_triangle(code.any, row_of, cut, signs);
  return cut.corners.size() >= 3;
}

// sum lambda_i v_i / sum lambda_i, +0 if it is 0. A vertex without weight takes no part. Rounded to
// float the mean of equal floats is their value: on an edge by itself, since both weights are
// positive; where two planes meet the sums may cancel, so that it is said.
template <std::floating_point V>
V weighted_mean(const barycentric::Meeting& m, const std::array<V, 3>& v, double reciprocal) {
  const bool of_two_planes = m.a->plane != 0 && m.b->plane != 0;
  if (of_two_planes && v[0] == v[1] && v[1] == v[2]) return v[0] + V(0);
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    if (m.magnitude[i] != 0) sum += m.lambda[i] * static_cast<double>(v[i]);
  }
  return static_cast<V>(sum * reciprocal);
}

// Where the meeting lies on a plane by construction, its coordinate or clip distance is set.
template <std::floating_point V, int K>
void set_on_planes(DepthRange depth, const barycentric::Meeting& m, ClipVertex<V, K>& v) {
  for_each_plane(barycentric::planes_of(m), kAllPlanes, [&](Plane plane) {
    if (is_clip_distance(plane)) {
      v.attributes[clip_distance_index(plane)] = 0;
      return;
    }
    const auto [axis, bound] = barycentric::plane_form(depth, plane);
    v.position[axis] = bound == 0 ? V(0) : bound * v.position[3];
  });
}

template <std::floating_point V, int K>
ClipVertex<V, K> mean_vertex(DepthRange depth, const barycentric::Meeting& m,
                             const ClipTriangle<V, K>& triangle) {
  const double reciprocal = 1 / barycentric::dot(m, barycentric::kOnes).value;
  const auto mean = [&](const auto& of) {
    return weighted_mean<V>(m, {of(triangle[0]), of(triangle[1]), of(triangle[2])}, reciprocal);
  };
  ClipVertex<V, K> v = triangle[0];
  for (int c = 0; c < 4; ++c) {
    v.position[c] = mean([c](const ClipVertex<V, K>& p) { return p.position[c]; });
  }
  for (int k = 0; k < v.attributes.size(); ++k) {
    v.attributes[k] = mean([k](const ClipVertex<V, K>& p) { return p.attributes[k]; });
  }
  set_on_planes(depth, m, v);
  return v;
}

// Every new vertex from the three own ones in double, rounded to V; a coordinate on its plane is
// set.
template <std::floating_point V, int K>
ClipPolygon<V, K> cut_from_originals(const ClipVolume& volume, const ClipTriangle<V, K>& triangle) {
  ClipPolygon<V, K> out;
  barycentric::CutTriangle cut;
  if (!cut_by_rounded_signs(volume, triangle, cut)) return out;
  for (const barycentric::Corner& corner : cut.corners) {
    const int own = barycentric::own_vertex(corner.at);
    const ClipVertex<V, K> v =
        own >= 0 ? triangle[own] : mean_vertex(volume.depth, corner.at, triangle);
    if (V(0) < v.position[3]) out.push_back(v);
  }
  out.drop_if_degenerate();
  return out;
}

// A projection in T from the frustum's floats, its matrix rounded to T.
template <std::floating_point T>
Projection<T> projection_in(const Projection<float>& projection) {
  if constexpr (std::same_as<T, float>) {
    return projection;
  } else {
    Projection<T> r(frustum_cast<T>(projection.frustum));
    r.volume = projection.volume;
    return r;
  }
}

// The full contract in double, rounded to float once at the end. clip(volume, triangle, polygon)
// clips and divides.
template <int K, class Clip>
void clip_in_double(const Projection<float>& projection, const ViewTriangle<float, K>& triangle,
                    NdcPolygon<float, K>& out, const Clip& clip) {
  const Projection<double> wide = projection_in<double>(projection);
  ClipTriangle<double, K> projected;
  for (std::size_t i = 0; i < 3; ++i) {
    projected[i] = to_clip(wide, vertex_cast<double>(triangle[i]));
  }
  NdcPolygon<double, K> polygon;
  clip(wide.volume, projected, polygon);
  out.clear();
  for (const NdcVertex<double, K>& v : polygon) out.push_back(vertex_cast<float>(v));
  clear_if_overflowed(out);  // finite in double, maybe not in float
}

}  // namespace clipscope::batch::plain

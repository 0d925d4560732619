// SPDX-License-Identifier: MIT
//
// The full contract in plain C++: one triangle at a time by the scalar clippers.
#pragma once

#include "spaces/batch/layout.hpp"
#include "spaces/batch/plain.hpp"
#include "spaces/view/sutherland_hodgman.hpp"

namespace clipscope::batch::plain {

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

template <class To, class From, int K>
void copy_attributes(const Attributes<From, K>& in, Attributes<To, K>& out) {
  out.resize(in.size());
  for (int k = 0; k < in.size(); ++k) out[k] = static_cast<To>(in[k]);
}

// Three vertices of 3 + K floats, or 3 + attributes for K = kRunTime.
template <int K>
ViewTriangle<float, K> read_view_triangle(const float* v, int attributes) {
  ViewTriangle<float, K> r;
  for (ViewVertex<float, K>& vertex : r) {
    for (int c = 0; c < 3; ++c) vertex.position[c] = *v++;
    vertex.attributes.resize(attributes);
    for (int k = 0; k < vertex.attributes.size(); ++k) vertex.attributes[k] = *v++;
  }
  return r;
}

// In double, as Sutherland and Hodgman or from the three own vertices, rounded to float once at the end.
template <int K>
void clip_in_double(Method method, const Projection<float>& projection,
                    const ViewTriangle<float, K>& triangle, NdcPolygon<float, K>& out) {
  const Projection<double> wide = projection_in<double>(projection);
  ClipTriangle<double, K> clip;
  for (std::size_t i = 0; i < 3; ++i) {
    clip[i].position = to_clip(wide, Vec3<double>(triangle[i].position));
    copy_attributes(triangle[i].attributes, clip[i].attributes);
  }
  NdcPolygon<double, K> polygon;
  if (method == Method::barycentric) {
    ClipPolygon<double, K> cut;
    clip_barycentric(wide.volume, clip, cut);
    divide(cut, polygon);
  } else {
    HomogeneousSutherlandHodgman{}(wide.volume, clip, polygon);
  }
  out.clear();
  for (const NdcVertex<double, K>& v : polygon) {
    NdcVertex<float, K> r{Vec4<float>(v.position), {}};
    copy_attributes(v.attributes, r.attributes);
    out.push_back(r);
  }
}

template <int K>
void clip_full(Method method, const Projection<float>& projection,
               const ViewTriangle<float, K>& triangle, NdcPolygon<float, K>& out) {
  switch (method) {
    case Method::view: return ViewSutherlandHodgman{}(projection, triangle, out);
    case Method::homogeneous: return HomogeneousSutherlandHodgman{}(projection, triangle, out);
    case Method::homogeneous_double:
    case Method::barycentric: return clip_in_double(method, projection, triangle, out);
    case Method::correctly_rounded: return CorrectlyRounded{}(projection, triangle, out);
  }
}

template <int K>
void full(Method method, const Projection<float>& projection, const ViewVertexArray& in,
          Output& out) {
  const OutputAccess access{out};
  access.begin(in.attributes);
  const std::size_t stride = 3 + static_cast<std::size_t>(in.attributes);
  NdcPolygon<float, K> polygon;
  for (std::size_t t = 0; t < in.count / 3; ++t) {
    clip_full(method, projection, read_view_triangle<K>(in.data + 3 * t * stride, in.attributes),
              polygon);
    Writer writer = access.block(1);
    write_polygon(polygon, writer.next);
    writer.add(t, polygon.size());
    access.commit(writer);
    ++(polygon.empty() ? access.tally().rejected : access.tally().plain);
  }
}

// Four attributes have code of their own.
inline void full(Method method, const Projection<float>& projection, const ViewVertexArray& in,
                 Output& out) {
  if (in.attributes == 4) return full<4>(method, projection, in, out);
  full<kRunTime>(method, projection, in, out);
}

}  // namespace clipscope::batch::plain

// SPDX-License-Identifier: MIT
#include "spaces/batch/plain.hpp"

#include "spaces/batch/methods.hpp"

namespace clipscope::batch::plain {
namespace {

// An inside triangle is usable as it is if every w is finite and positive.
template <int K>
bool is_usable(const ClipTriangle<float, K>& triangle) {
  for (const ClipVertex<float, K>& v : triangle) {
    if (!(0 < v.position[3]) || !has_finite_position(v)) return false;
  }
  return true;
}

template <int K>
ClipTriangle<float, K> read_triangle(const float* const vertex[3], int attributes) {
  ClipTriangle<float, K> r;
  for (std::size_t i = 0; i < 3; ++i) r[i] = read_vertex<K>(vertex[i], attributes);
  return r;
}

// Both return how many vertices the polygon has.
template <int K>
int write_cut(Method method, const ClipVolume& volume, const ClipTriangle<float, K>& triangle,
              float* out) {
  int vertices = 0;
  with_method(method, [&]<class M>() {
    if constexpr (HasStage<M>) {
      const ClipPolygon<float, K> polygon = M::cut(volume, triangle);
      write_vertices(polygon, out);
      vertices = polygon.size();
    }
  });
  return vertices;
}

template <int K>
int write_full(Method method, const Projection<float>& projection,
               const ViewTriangle<float, K>& triangle, float* out) {
  NdcPolygon<float, K> polygon;
  with_method(method, [&]<class M>() {
    if constexpr (HasFull<M>) M{}(projection, triangle, polygon);
  });
  write_vertices(polygon, out);
  return polygon.size();
}

// Where the triangles that are inside go.
enum class Inside { written, named };

// triangle_at(t) gives triangle t as ClipTriangle<float, K>.
template <int K, class TriangleAt>
void run(Method method, const ClipVolume& volume, std::size_t triangles, int attributes,
         Inside inside, TriangleAt&& triangle_at, Output& out) {
  const OutputAccess access{out};
  access.begin(attributes);
  Tally& tally = access.tally();
  for (std::size_t t = 0; t < triangles; ++t) {
    Writer writer = access.block(1);
    const ClipTriangle<float, K> triangle = triangle_at(t);
    const OutcodeSummary code = summarize_outcodes(volume, triangle, [&](std::size_t i) {
      return clip_outcode(volume.depth, triangle[i].position);
    });
    const bool is_rejected = code.all != 0 || is_beyond_open_side(volume, triangle);
    const bool is_inside = !is_rejected && code.any == 0 && is_usable(triangle);
    tally.inside += is_inside;
    tally.rejected += is_rejected;
    tally.plain += !is_rejected && !is_inside;
    if (is_inside && inside == Inside::named) {
      *writer.inside++ = static_cast<std::uint32_t>(t);
    } else if (is_inside) {
      write_vertices(triangle, writer.next);
      writer.add(t, 3);
    } else if (!is_rejected) {
      writer.add(t, write_cut(method, volume, triangle, writer.next));
    }
    access.commit(writer);
  }
}

// Four attributes have code of their own.
template <class TriangleAt>
void run(Method method, const ClipVolume& volume, std::size_t triangles, int attributes,
         Inside inside, TriangleAt&& triangle_at, Output& out) {
  const auto with = [&]<int K>(std::integral_constant<int, K>) {
    run<K>(
        method, volume, triangles, attributes, inside,
        [&](std::size_t t) { return triangle_at(std::integral_constant<int, K>(), t); }, out);
  };
  if (attributes == 4) {
    with(std::integral_constant<int, 4>());
  } else {
    with(std::integral_constant<int, kRunTime>());
  }
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

template <int K>
void full(Method method, const Projection<float>& projection, const ViewVertexArray& in,
          Output& out) {
  const OutputAccess access{out};
  access.begin(in.attributes);
  const std::size_t stride = 3 + static_cast<std::size_t>(in.attributes);
  for (std::size_t t = 0; t < in.count / 3; ++t) {
    Writer writer = access.block(1);
    const auto triangle = read_view_triangle<K>(in.data + 3 * t * stride, in.attributes);
    const int vertices = write_full(method, projection, triangle, writer.next);
    writer.add(t, vertices);
    access.commit(writer);
    ++(vertices == 0 ? access.tally().rejected : access.tally().plain);
  }
}

}  // namespace

void copy(Method method, const ClipVolume& volume, const VertexArray& in, Output& out) {
  const auto at = [&]<int K>(std::integral_constant<int, K>, std::size_t t) {
    ClipTriangle<float, K> r;
    for (std::size_t i = 0; i < 3; ++i) {
      r[i] = read_vertex<K>(in.data + (3 * t + i) * in.stride(), in.attributes);
    }
    return r;
  };
  run(method, volume, in.count / 3, in.attributes, Inside::written, at, out);
}

void reference(Method method, const ClipVolume& volume, const TriangleStreams& in, Output& out) {
  const auto at = [&]<int K>(std::integral_constant<int, K>, std::size_t t) {
    ClipTriangle<float, K> r;
    for (std::size_t i = 0; i < 3; ++i) {
      for (int c = 0; c < 4; ++c) r[i].position[c] = in.positions[i][c][t];
      r[i].attributes.resize(in.attribute_count);
      for (int k = 0; k < in.attribute_count; ++k) {
        r[i].attributes[k] =
            in.attributes[(3 * t + i) * static_cast<std::size_t>(in.attribute_count) + k];
      }
    }
    return r;
  };
  run(method, volume, in.count, in.attribute_count, Inside::named, at, out);
}

void indexed(Method method, const ClipVolume& volume, const IndexedMesh& mesh, Output& out) {
  const VertexArray& in = mesh.vertices;
  const auto at = [&]<int K>(std::integral_constant<int, K>, std::size_t t) {
    ClipTriangle<float, K> r;
    for (std::size_t i = 0; i < 3; ++i) {
      r[i] = read_vertex<K>(in.data + mesh.indices[3 * t + i] * in.stride(), in.attributes);
    }
    return r;
  };
  run(method, volume, mesh.indices.size() / 3, in.attributes, Inside::named, at, out);
}

// Four attributes have code of their own.
void full(Method method, const Projection<float>& projection, const ViewVertexArray& in,
          Output& out) {
  if (in.attributes == 4) return full<4>(method, projection, in, out);
  full<kRunTime>(method, projection, in, out);
}

int cut(Method method, const ClipVolume& volume, int attributes, const float* const vertex[3],
        float* out) {
  if (attributes == 4) return write_cut(method, volume, read_triangle<4>(vertex, 4), out);
  return write_cut(method, volume, read_triangle<kRunTime>(vertex, attributes), out);
}

void write_corner(DepthRange depth, std::size_t floats, const float* const vertex[3], int from,
                  int to, const std::uint32_t* open, float* out) {
  const auto values = [&](std::size_t i) {
    return barycentric::Values{vertex[0][i], vertex[1][i], vertex[2][i]};
  };
  const barycentric::Values w = values(3);
  barycentric::Line rows[2];
  const auto line = [&](int number, barycentric::Line& row) -> const barycentric::Line& {
    if (number < 3) return barycentric::kEdges[static_cast<std::size_t>(number)];
    const Plane plane = static_cast<Plane>(number - 3);
    const barycentric::PlaneForm form = barycentric::plane_form(depth, plane);
    return row = barycentric::clip_row(form, plane, values(static_cast<std::size_t>(form.axis)), w);
  };
  const barycentric::Meeting at = barycentric::meet(line(from, rows[0]), line(to, rows[1]));
  const barycentric::Divisor sum = barycentric::divisor(at, barycentric::kOnes);
  barycentric::CountNothing count;
  for (std::size_t i = 0; i < floats; ++i) {
    if (open[i] != 0) out[i] = barycentric::rounded_quotient(at, values(i), sum, count);
  }
}

int cut_full(Method method, const Projection<float>& projection, int attributes,
             const float* vertices, float* out) {
  if (attributes == 4) {
    return write_full(method, projection, read_view_triangle<4>(vertices, 4), out);
  }
  return write_full(method, projection, read_view_triangle<kRunTime>(vertices, attributes), out);
}

}  // namespace clipscope::batch::plain

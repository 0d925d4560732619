// SPDX-License-Identifier: MIT
//
// What the plain and the SIMD code of the batch clippers share: where results go, and what a
// vertex's code says.
#pragma once

#include <algorithm>
#include <cstring>

#include "spaces/batch/batch.hpp"
#include "spaces/planes.hpp"
#include "spaces/polygon.hpp"

namespace clipscope::batch {

// Triangles are classified, then cut, in blocks: what some blocks read and write stays in cache.
inline constexpr std::size_t kBlock = 256;

// Where triangles inside are not copied blocks are larger, so that lanes fill up with straddlers.
inline constexpr std::size_t kMostBlock = 1024;

// Room that is kept free behind the last vertex, since whole vectors are stored.
inline constexpr std::size_t kSlack = 64;

// A triangle of n planes has 3 + n vertices at most.
inline constexpr std::size_t kMostVertices = 3 + kMaxPlanes;

// Where the polygons of a block go.
struct Writer {
  float* next;  // the next polygon's vertices
  PolygonEnd* polygons;
  std::size_t stride;  // floats per vertex
  std::uint32_t end;   // vertices so far, in all
  std::uint32_t* inside;

  // Notes a polygon that was written to `next`.
  void add(std::size_t triangle, int vertices) {
    if (vertices == 0) return;
    next += static_cast<std::size_t>(vertices) * stride;
    end += static_cast<std::uint32_t>(vertices);
    *polygons++ = {static_cast<std::uint32_t>(triangle), end};
  }
  // Notes so many triangles whose vertices were written to `next`; number(i): that of the i-th.
  template <class F>
  void add_triangles(std::size_t count, F&& number) {
    PolygonEnd* const to = polygons;
    const std::uint32_t begin = end;
    for (std::size_t i = 0; i < count; ++i) {
      to[i] = {static_cast<std::uint32_t>(number(i)),
               begin + 3 * static_cast<std::uint32_t>(i + 1)};
    }
    polygons += count;
    end += 3 * static_cast<std::uint32_t>(count);
    next += 3 * count * stride;
  }
};

// The clippers' way into an Output.
struct OutputAccess {
  Output& out;

  void begin(int attributes) const {
    out.inside_count_ = out.polygon_count_ = out.vertex_count_ = 0;
    out.stride_ = 4 + static_cast<std::size_t>(attributes);
    out.tally_ = {};
  }
  // Room for so many more triangles, whatever becomes of them.
  Writer block(std::size_t triangles) const {
    grow(out.inside_, out.inside_count_ + triangles + kSlack);
    grow(out.polygons_, out.polygon_count_ + triangles);
    grow(out.vertices_, (out.vertex_count_ + triangles * kMostVertices) * out.stride_ + kSlack);
    return {out.vertices_.data() + out.vertex_count_ * out.stride_,
            out.polygons_.data() + out.polygon_count_, out.stride_,
            static_cast<std::uint32_t>(out.vertex_count_), out.inside_.data() + out.inside_count_};
  }
  void commit(const Writer& w) const {
    out.vertex_count_ = w.end;
    out.polygon_count_ = static_cast<std::size_t>(w.polygons - out.polygons_.data());
    out.inside_count_ = static_cast<std::size_t>(w.inside - out.inside_.data());
  }
  std::uint16_t* codes(std::size_t count) const {
    grow(out.codes_, count);
    return out.codes_.data();
  }
  Tally& tally() const { return out.tally_; }

 private:
  // Doubles the size, so that growing is rare.
  template <class V>
  static void grow(V& v, std::size_t size) {
    if (v.size() < size) v.resize(std::max(size, 2 * v.size()));
  }
};

// Bits of a vertex's code, one per plane by axis: bit c is coordinate c above w, bit 4 + c below
// its lower bound. Two more say that w is not finite, or not positive. A NaN sets the bits of all
// its comparisons.
inline constexpr unsigned kPlaneBits = 0x77;

// A plane's bit, and its signed distance w_weight w + c_weight c of a vertex. The weights are 0, 1
// and -1, so that the distance has the bits of `clip_distance` (spaces/planes.hpp).
struct CodePlane {
  int bit, axis;
  float w_weight, c_weight;
};

// The planes of a volume in the order in which homogeneous/sutherland_hodgman cuts: near, far,
// left, right, bottom, top.
constexpr std::array<CodePlane, kPlanes> code_planes(DepthRange depth) {
  const float lowest_z = depth == DepthRange::minus_one_to_one ? 1.0f : 0.0f;
  const CodePlane z_low{6, 2, lowest_z, 1}, z_high{2, 2, 1, -1};
  const bool reversed = depth == DepthRange::reversed;
  return {reversed ? z_high : z_low, reversed ? z_low : z_high, CodePlane{4, 0, 1, 1},
          CodePlane{0, 0, 1, -1},    CodePlane{5, 1, 1, 1},     CodePlane{1, 1, 1, -1}};
}

// The same in view space, of vertices (x, y, z, 1): own c + z_weight z + constant, with the bits of
// `view_distance`, in the order in which view/sutherland_hodgman cuts. An infinite far plane is the
// constant 1.
struct ViewCodePlane {
  int bit, axis;
  float own, z_weight, constant;
};

constexpr std::array<ViewCodePlane, kPlanes> view_code_planes(const Frustum<float>& f) {
  const bool perspective = f.kind == ProjectionKind::perspective;
  const auto side = [&](int bit, int axis, float sign, float bound, float shear) {
    if (perspective) return ViewCodePlane{bit, axis, sign * f.near, sign * bound, 0};
    return ViewCodePlane{bit, axis, sign, sign * shear, -sign * bound};
  };
  return {side(4, 0, 1, f.left, f.shear_x),
          side(0, 0, -1, f.right, f.shear_x),
          side(5, 1, 1, f.bottom, f.shear_y),
          side(1, 1, -1, f.top, f.shear_y),
          ViewCodePlane{6, 2, -1, 0, -f.near},
          f.infinite_far ? ViewCodePlane{2, 2, 0, 0, 1} : ViewCodePlane{2, 2, 1, 0, f.far}};
}

// A vertex of 4 + K floats, or 4 + attributes for K = kRunTime, from and to memory.
template <int K>
ClipVertex<float, K> read_vertex(const float* v, int attributes) {
  ClipVertex<float, K> r;
  for (int c = 0; c < 4; ++c) r.position[c] = v[c];
  r.attributes.resize(attributes);
  for (int k = 0; k < r.attributes.size(); ++k) r.attributes[k] = v[4 + k];
  return r;
}

template <class Vertices>
void write_vertices(const Vertices& vertices, float* out) {
  for (const auto& v : vertices) {
    for (int c = 0; c < 4; ++c) *out++ = v.position[c];
    for (int k = 0; k < v.attributes.size(); ++k) *out++ = v.attributes[k];
  }
}

}  // namespace clipscope::batch

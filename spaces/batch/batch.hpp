// SPDX-License-Identifier: MIT
//
// Batch clippers: many triangles in one call, as a renderer has them, in SIMD.
//
// Two timing contracts. The *stage* is the clipper in a renderer's pipeline: clip-space triangles
// in, clip-space polygons out, no divide. It comes in three output contracts:
//
//   copy       an array of vertices in, three per triangle; every surviving triangle is written out
//   reference  positions as structure of arrays in; triangles that are inside come out as their
//              numbers, only cut ones are written
//   indexed    an indexed mesh in, each vertex classified once; out as in `reference`
//
// *Full* is the contract of spaces/clipper.hpp: view space in, NDC out, every survivor written.
//
// What all share:
//   - Triangles and polygons come out in the order of the input, polygons in the winding of the
//     input. A polygon begins at any of its vertices.
//   - Volumes with clip distances, depth clamp or open sides are clipped by the plain version.
//   - NaN and infinity: the policy of spaces/clipper.hpp. In the stage a result overflows where a
//     coordinate of a new vertex does. Vertices with w <= 0 (in the volume only (0, 0, 0, 0)) are
//     left out.
//   - Functions are thread-safe: no state but the Output, which belongs to one thread at a time.
//     They do not throw, but for std::bad_alloc when an Output grows: by blocks of triangles, and
//     no more once it has met a call as large.
//   - The bits of the answer do not depend on the instruction set: the plain version and every
//     target of the run-time dispatch give the same.
//
// Source: outcodes: Sproull and Sutherland, "A Clipping Divider", 1968; Blinn and Newell, "Clipping
// Using Homogeneous Coordinates", SIGGRAPH 1978. Portable SIMD with run-time dispatch: Highway.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spaces/clipper.hpp"
#include "spaces/projection.hpp"
#include "spaces/volume.hpp"

namespace clipscope::batch {

// The list of all methods: types, in methods.hpp, each with its source and promise. To add one:
// write its header, include it there and add its name here; everything else follows.
using AllMethods = TypeList<
    // Cuts in view space, plane after plane, in float; full contract only.
    struct ViewBatch,
    // Sutherland-Hodgman in clip space in float: the bits of its plain twin.
    struct HomogeneousBatch,
    // The same bits, as long as nothing overflows, by McGuire's cases, a triangle in each lane; the
    // stage only.
    struct McGuireBatch,
    // The same in double, rounded to float once at the end.
    struct HomogeneousBatchDouble,
    // Every new vertex from the three original ones, in double, rounded once.
    struct BarycentricBatch,
    // Decisions exact, every float the one nearest to the exact value.
    struct CorrectlyRoundedBatch>;

// A method of the list as a value: its place there.
enum class Method : std::uint8_t {
  view = index_of<ViewBatch>(AllMethods{}),
  homogeneous = index_of<HomogeneousBatch>(AllMethods{}),
  mcguire = index_of<McGuireBatch>(AllMethods{}),
  homogeneous_double = index_of<HomogeneousBatchDouble>(AllMethods{}),
  barycentric = index_of<BarycentricBatch>(AllMethods{}),
  correctly_rounded = index_of<CorrectlyRoundedBatch>(AllMethods{})
};
template <class M>
inline constexpr Method kMethod{index_of<M>(AllMethods{})};

std::string_view name(Method method);  // "homogeneous/batch" and so on

// Which code runs: a loop over triangles that the compiler makes of portable C++, or SIMD by
// Highway for the best instruction set of this processor.
enum class Build : std::uint8_t { plain, simd };

// Vertices one after the other, each x y z w and then its attributes: 4 + attributes floats.
struct VertexArray {
  const float* data = nullptr;
  std::size_t count = 0;  // vertices
  int attributes = 0;     // 0 to kMaxAttributes

  std::size_t stride() const { return 4 + static_cast<std::size_t>(attributes); }
};

// Triangles whose positions are twelve arrays: coordinate c (x y z w) of vertex v of triangle t is
// positions[v][c][t]. Attribute k of it is attributes[(3 t + v) attribute_count + k].
struct TriangleStreams {
  std::array<std::array<const float*, 4>, 3> positions{};
  std::size_t count = 0;  // triangles
  const float* attributes = nullptr;
  int attribute_count = 0;  // 0 to kMaxAttributes
};

// Triangle t has the vertices indices[3 t], indices[3 t + 1], indices[3 t + 2].
// Pre-condition: every index is below vertices.count.
struct IndexedMesh {
  VertexArray vertices;
  std::span<const std::uint32_t> indices;
};

// View-space vertices one after the other: x y z and then the attributes, 3 + attributes floats;
// three per triangle.
struct ViewVertexArray {
  const float* data = nullptr;
  std::size_t count = 0;  // vertices
  int attributes = 0;     // 0 to kMaxAttributes
};

// Polygon i has the vertices [end of polygon i - 1, end), 0 for the first one's begin.
struct PolygonEnd {
  std::uint32_t triangle;  // its number in the input
  std::uint32_t end;
};

// How many triangles of a call took which way; sums up to the triangles.
struct Tally {
  std::uint64_t rejected = 0, inside = 0;
  std::uint64_t one_plane = 0;  // cut by one plane, in the branch-free path
  std::uint64_t planes = 0;     // cut by several
  std::uint64_t exact = 0;      // correctly rounded: with a decision that expansions had to settle
  std::uint64_t exact_vertices = 0;  // correctly rounded: new vertices with floats that they had to
  std::uint64_t plain = 0;           // handed to the plain version
};

// Memory that begins with a cache line, so that a vertex of eight floats lies in one.
template <class T>
struct LineAllocator {
  using value_type = T;
  static constexpr std::align_val_t kLine{64};

  LineAllocator() = default;
  template <class U>
  LineAllocator(const LineAllocator<U>&) {}

  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new(count * sizeof(T), kLine));
  }
  void deallocate(T* p, std::size_t) { ::operator delete(p, kLine); }
  bool operator==(const LineAllocator&) const { return true; }
};

// What a call leaves behind; reused from call to call it allocates no more. A vertex is 4 +
// attributes floats: x y z w, in the full contract x y z 1/w.
class Output {
 public:
  std::span<const std::uint32_t> inside() const { return {inside_.data(), inside_count_}; }
  std::span<const PolygonEnd> polygons() const { return {polygons_.data(), polygon_count_}; }
  // All vertices: those of a polygon are contiguous.
  std::span<const float> vertices() const { return {vertices_.data(), vertex_count_ * stride_}; }
  std::span<const float> polygon(std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : polygons_[i - 1].end;
    return {vertices_.data() + begin * stride_, (polygons_[i].end - begin) * stride_};
  }
  std::size_t stride() const { return stride_; }  // floats per vertex
  const Tally& tally() const { return tally_; }

 private:
  friend struct OutputAccess;  // the clippers'

  // Sizes are kept apart, so that growing room for a block writes nothing.
  std::vector<std::uint32_t> inside_;
  std::vector<PolygonEnd> polygons_;
  std::vector<float, LineAllocator<float>> vertices_;
  std::vector<std::uint16_t> codes_;  // of the vertices of a mesh
  std::size_t inside_count_ = 0, polygon_count_ = 0, vertex_count_ = 0, stride_ = 4;
  Tally tally_;
};

// The stage. Every call begins `out` anew. Pre-conditions: a method of kStageMethods (methods.hpp);
// the counts of vertices and of indices are multiples of three; fewer than 2^32 / 9 triangles.
void clip(Method method, const ClipVolume& volume, const VertexArray& triangles, Output& out,
          Build build = Build::simd);
void clip(Method method, const ClipVolume& volume, const TriangleStreams& triangles, Output& out,
          Build build = Build::simd);
void clip(Method method, const ClipVolume& volume, const IndexedMesh& mesh, Output& out,
          Build build = Build::simd);

// The full contract.
void clip(Method method, const Projection<float>& projection, const ViewVertexArray& triangles,
          Output& out, Build build = Build::simd);

// The instruction set that Build::simd runs on: "AVX2" and so on; "plain" where none here has
// vectors of doubles and the plain version answers.
std::string target_name();

}  // namespace clipscope::batch

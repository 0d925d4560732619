// SPDX-License-Identifier: MIT
//
// The stage in its three output contracts: triangles are classified block by block, without a
// branch, and what survives is copied, named or cut in the order of the input.
#if defined(CLIPSCOPE_BATCH_STAGE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CLIPSCOPE_BATCH_STAGE_INL
#undef CLIPSCOPE_BATCH_STAGE_INL
#else
#define CLIPSCOPE_BATCH_STAGE_INL
#endif

#include "spaces/batch/barycentric-inl.hpp"
#include "spaces/batch/lanes-inl.hpp"
#include "spaces/batch/mesh-inl.hpp"
#include "spaces/batch/methods.hpp"
#include "spaces/batch/streams-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

template <class M>
inline constexpr bool kIsView = M::simd == Simd::view_planes;

// Cuts one triangle of a space at a time by a method. The vertices are of V, and so is what comes
// out.
template <class M, int K, class V>
class Cutter {
 public:
  using S = Shape<K>;
  using Limits = std::conditional_t<kIsView<M>, ViewLimits, ClipLimits>;
  using CutPlane = std::conditional_t<kIsView<M>, ViewCodePlane, CodePlane>;

  Cutter(DepthRange depth, int attributes)
      : shape{attributes}, limits(depth), depth_(depth), planes_(planes_in(depth)) {
    index_planes();
  }
  Cutter(const Frustum<float>& frustum, int attributes)
      : shape{attributes},
        limits(view_code_planes(frustum)),
        depth_(frustum.depth),
        planes_(view_code_planes(frustum)) {
    index_planes();
  }

  const S shape;
  const Limits limits;

  // In the order in which they cut.
  const std::array<CutPlane, kPlanes>& planes() const { return planes_; }

  // Vertices written to `out`, or kGiveUp: then the plain version has to do it. any: the bits that
  // some vertex has; not 0.
  HWY_INLINE int cut(const V* const vertex[3], unsigned any, V* out, Tally& tally) const {
    if (!is_moderate(shape, vertex)) {
      ++tally.plain;
      return kGiveUp;
    }
    const bool one = (any & kPlaneBits) != 0 && (any & (any - 1)) == 0;
    ++(one ? tally.one_plane : tally.planes);
    const int count = one ? way(tally).cut_one_plane(vertex, by_bit_[std::countr_zero(any)], out)
                          : cut_planes(vertex, any, out, tally);
    if (count == kGiveUp) {
      --(one ? tally.one_plane : tally.planes);
      ++(M::promise.correctly_rounded ? tally.exact : tally.plain);
    }
    return count;
  }

 private:
  static constexpr bool kIsChain = M::simd != Simd::originals;
  using ChainOf = Chain<typename M::Number, S, Limits, CutPlane>;
  using Originals = FromOriginals<M::promise.correctly_rounded, S>;

  static std::array<CodePlane, kPlanes> planes_in(DepthRange depth) {
    auto planes = code_planes(depth);
    // In the order of `kAllPlanes`.
    if (!kIsChain) std::rotate(planes.begin(), planes.begin() + 2, planes.end());
    return planes;
  }

  void index_planes() {
    for (const CutPlane& plane : planes_) by_bit_[plane.bit] = plane;
  }

  // From plane to plane, or from the three own vertices.
  HWY_INLINE auto way([[maybe_unused]] Tally& tally) const {
    if constexpr (kIsChain) {
      return ChainOf{shape, limits, planes_};
    } else {
      return Originals{shape, planes_, depth_, tally};
    }
  }

  HWY_NOINLINE int cut_planes(const V* const vertex[3], unsigned any, V* out, Tally& tally) const {
    const Straddler<V> s{{vertex[0], vertex[1], vertex[2]},
                         {vertex_code(limits, vertex[0]), vertex_code(limits, vertex[1]),
                          vertex_code(limits, vertex[2])},
                         any};
    return way(tally).cut_planes(s, out);
  }

  const DepthRange depth_;
  const std::array<CutPlane, kPlanes> planes_;
  std::array<CutPlane, 8> by_bit_{};
};

// Eight floats in one register, where there is one.
template <class D>
HWY_INLINE void store_eight(D d, hn::Vec<D4> low, hn::Vec<D4> high, float* out) {
  if constexpr (hn::MaxLanes(D()) == 8) {
    hn::StoreU(hn::Combine(d, high, low), d, out);
  } else {
    hn::StoreU(low, kD4, out);
    hn::StoreU(high, kD4, out + 4);
  }
}

// A triangle's vertices as whole vectors: those of the input, or copies with zeros behind.
template <class S, class V = float>
class Padded {
 public:
  const V* vertex[3];

  HWY_INLINE void set(const S& shape, const V* a, const V* b, const V* c) {
    if constexpr (S::kLoadsInPlace) {
      vertex[0] = a;
      vertex[1] = b;
      vertex[2] = c;
    } else {
      const V* from[3] = {a, b, c};
      for (int i = 0; i < 3; ++i) {
        std::memcpy(memory_[i], from[i], shape.floats() * sizeof(V));
        vertex[i] = memory_[i];
      }
    }
  }

  // Triangle t of streams. A vertex of four attributes is stored as one register, since it is
  // loaded as one.
  HWY_INLINE void set(const S& shape, const TriangleStreams& in, std::size_t t) {
    const std::size_t attributes = shape.floats() - 4;
    for (int i = 0; i < 3; ++i) {
      const auto& p = in.positions[i];
      const auto xy = hn::InterleaveLower(kD4, hn::Set(kD4, p[0][t]), hn::Set(kD4, p[1][t]));
      const auto zw = hn::InterleaveLower(kD4, hn::Set(kD4, p[2][t]), hn::Set(kD4, p[3][t]));
      const auto position = hn::ConcatLowerLower(kD4, zw, xy);
      const float* const from = in.attributes + (3 * t + i) * attributes;
      if constexpr (S::kFixed && S::kMostFloats == 8) {
        store_eight(kD8, position, hn::LoadU(kD4, from), memory_[i]);
      } else {
        hn::Store(position, kD4, memory_[i]);
        std::copy_n(from, attributes, memory_[i] + 4);
      }
      vertex[i] = memory_[i];
    }
  }

 private:
  HWY_ALIGN V memory_[3][S::kWidth] = {};
};

// The bits that some of three vertices have, and those that all have.
HWY_INLINE Codes codes_of(const ClipLimits& limits, const float* const vertex[3]) {
  const unsigned a = vertex_code(limits, vertex[0]), b = vertex_code(limits, vertex[1]),
                 c = vertex_code(limits, vertex[2]);
  return {a & b & c, a | b | c};
}

// The stage in its contracts, one call of one of them: the cutter with the plain version behind it,
// and what a block of triangles needs.
template <class M, int K>
class Stage {
 public:
  Stage(const ClipVolume& volume, int attributes, Output& out)
      : volume_(volume), cutter_(volume.depth, attributes), access_{out}, lanes_(cutter_.planes()) {
    access_.begin(attributes);
  }

  void copy(const VertexArray& in) {
    const std::size_t stride = cutter_.shape.floats();
    for_each_block<kGroup>(in.count / 3, [&](std::size_t first, std::size_t count) {
      classify_group(cutter_.limits, in.data + 3 * first * stride, stride, count, at_once_);
      for_each_block(count, [&](std::size_t begin, std::size_t size) {
        copy_block(in.data, first + begin, size, at_once_[begin / kBlock]);
      });
    });
  }

  void reference(const TriangleStreams& in) {
    for_each_block(in.count, [&](std::size_t first, std::size_t count) {
      Writer writer = begin_block(count);
      const std::uint32_t* const inside = writer.inside;
      survivors_.count = 0;
      std::size_t t = classify_streams(hn::ScalableTag<float>(), cutter_.limits, in, first, count,
                                       writer, survivors_);
      for (; t < count; ++t) {  // what is left of a vector
        padded_.set(cutter_.shape, in, first + t);
        const Codes codes = codes_of(cutter_.limits, padded_.vertex);
        if (codes.any == 0) *writer.inside++ = static_cast<std::uint32_t>(first + t);
        survivors_.triangle[survivors_.count] = static_cast<std::uint16_t>(t);
        survivors_.count += codes.any != 0 && (codes.all & kPlaneBits) == 0;
      }
      count_uncut(count, inside, writer);
      for (std::size_t i = 0; i < survivors_.count; ++i) {
        const std::size_t triangle = first + survivors_.triangle[i];
        padded_.set(cutter_.shape, in, triangle);
        cut(codes_of(cutter_.limits, padded_.vertex).any, triangle, writer,
            Place{i, survivors_.count, nullptr}, [&](std::size_t at, std::size_t lane, int v) {
              return lanes_.hold(in, first + survivors_.triangle[at], lane, v);
            });
      }
      access_.commit(writer);
    });
  }

  void indexed(const IndexedMesh& mesh) {
    std::uint16_t* const codes = access_.codes(mesh.vertices.count);
    classify_vertices(cutter_.limits, mesh.vertices, cutter_.shape.floats(), codes);
    MeshBlock block;
    for_each_block(mesh.indices.size() / 3, [&](std::size_t first, std::size_t count) {
      const auto indices = mesh.indices.subspan(3 * first, 3 * count);
      Writer writer = begin_block(count);
      const std::uint32_t* const inside = writer.inside;
      block.classify(codes, indices);
      block.sort(count, first, writer, survivors_);
      count_uncut(count, inside, writer);
      cut_survivors(mesh.vertices.data, indices.data(), first, writer);
      access_.commit(writer);
    });
  }

 private:
  // f(first, count) of each, kSize triangles but for the last.
  template <std::size_t kSize = kBlock, class F>
  static HWY_INLINE void for_each_block(std::size_t triangles, F&& f) {
    for (std::size_t first = 0; first < triangles; first += kSize) {
      f(first, std::min(kSize, triangles - first));
    }
  }

  // Room for so many triangles.
  HWY_INLINE Writer begin_block(std::size_t triangles) {
    lanes_.forget();
    return access_.block(triangles);
  }

  // Triangles [first, first + count), as classified.
  HWY_INLINE void copy_block(const float* vertices, std::size_t first, std::size_t count,
                             const Survivors& survivors) {
    const std::size_t stride = cutter_.shape.floats();
    const float* const block = vertices + first * 3 * stride;
    Writer writer = begin_block(survivors.count);
    access_.tally().rejected += count - survivors.count;
    std::size_t i = copy_run(block, first, survivors, 0, writer);
    for (; i < survivors.count; i = copy_run(block, first, survivors, i + 1, writer)) {
      const std::size_t t = survivors.triangle[i];
      const float* v = block + 3 * t * stride;
      padded_.set(cutter_.shape, v, v + stride, v + 2 * stride);
      cut(survivors.any[i], first + t, writer, Place{i, survivors.count, survivors.any},
          [&](std::size_t at, std::size_t, int vertex) {
            return block + (3 * survivors.triangle[at] + static_cast<std::size_t>(vertex)) * stride;
          });
    }
    access_.commit(writer);
  }

  // Copies survivors from `begin` on as long as they are inside, and returns the first that is not.
  // Polygons are noted after the vertices: stores to two places in turn take twice as long.
  HWY_INLINE std::size_t copy_run(const float* block, std::size_t first, const Survivors& survivors,
                                  std::size_t begin, Writer& writer) const {
    const std::size_t size = 3 * cutter_.shape.floats();
    float* next = writer.next;
    std::size_t end = begin;
    for (; end < survivors.count && survivors.any[end] == 0; ++end, next += size) {
      copy_triangle(cutter_.shape, block + survivors.triangle[end] * size, next);
    }
    writer.add_triangles(first, survivors.triangle + begin, end - begin);
    access_.tally().inside += end - begin;
    return end;
  }

  // The triangles of a block that need no cut. inside: where the writer's numbers began.
  HWY_INLINE void count_uncut(std::size_t triangles, const std::uint32_t* inside,
                              const Writer& writer) const {
    const auto inside_count = static_cast<std::size_t>(writer.inside - inside);
    access_.tally().inside += inside_count;
    access_.tally().rejected += triangles - inside_count - survivors_.count;
  }

  // Cuts the survivors of a mesh's block, whose indices these are; `first` is its first triangle.
  HWY_INLINE void cut_survivors(const float* vertices, const std::uint32_t* indices,
                                std::size_t first, Writer& writer) {
    constexpr std::size_t kAhead = 8;
    const std::size_t stride = cutter_.shape.floats(), count = survivors_.count;
    const auto vertex = [&](std::size_t i, std::size_t v) {
      return vertices + indices[3 * survivors_.triangle[i] + v] * stride;
    };
    const auto prefetch = [&](std::size_t i) {
      for (std::size_t v = 0; v < 3; ++v) prefetch_floats(vertex(i, v), stride);
    };
    for (std::size_t i = 0; i < std::min(kAhead, count); ++i) prefetch(i);
    for (std::size_t i = 0; i < count; ++i) {
      if (i + kAhead < count) prefetch(i + kAhead);
      padded_.set(cutter_.shape, vertex(i, 0), vertex(i, 1), vertex(i, 2));
      cut(survivors_.any[i], first + survivors_.triangle[i], writer, Place{i, count, nullptr},
          [&](std::size_t at, std::size_t, int v) {
            return vertex(at, static_cast<std::size_t>(v));
          });
    }
  }

  // A survivor among those of its block; any: the bits of all of them, 0 for those that are not
  // cut, or null if all are.
  struct Place {
    std::size_t at, count;
    const std::uint8_t* any;
  };

  // Cuts the triangle in `padded_`. position(at, lane, v): where the position of vertex v of a
  // survivor lies, as long as it goes to that lane.
  template <class F>
  HWY_INLINE void cut(unsigned any, std::size_t triangle, Writer& writer,
                      [[maybe_unused]] Place place, [[maybe_unused]] F&& position) {
    if constexpr (kInLanes) {
      const auto needs = [&](std::size_t at) { return place.any == nullptr || place.any[at] != 0; };
      const std::size_t lane = lanes_.lane_of(place.at, place.count, needs, position);
      if (is_moderate(cutter_.shape, padded_.vertex)) {
        const int count = lanes_.write(cutter_.shape, lane, padded_.vertex, writer.next);
        if (count != kGiveUp) {
          const bool one = (any & kPlaneBits) != 0 && (any & (any - 1)) == 0;
          ++(one ? access_.tally().one_plane : access_.tally().planes);
          writer.add(triangle, count);
          return;
        }
      }
    }
    cut(any, triangle, writer);
  }

  HWY_NOINLINE void cut(unsigned any, std::size_t triangle, Writer& writer) const {
    int count = cutter_.cut(padded_.vertex, any, writer.next, access_.tally());
    if (count == kGiveUp) {
      count =
          plain::cut(kMethod<M>, volume_, cutter_.shape.attributes, padded_.vertex, writer.next);
    }
    writer.add(triangle, count);
  }

  static constexpr bool kInLanes = M::simd == Simd::clip_lanes;
  struct NoLanes {
    explicit NoLanes(const std::array<CodePlane, kPlanes>&) {}
    void forget() {}
    const float* hold(const TriangleStreams&, std::size_t, std::size_t, int) { return nullptr; }
  };

  const ClipVolume volume_;
  const Cutter<M, K, float> cutter_;
  const OutputAccess access_;
  Padded<Shape<K>> padded_;
  std::conditional_t<kInLanes, LaneCutter, NoLanes> lanes_;
  Survivors survivors_;                           // of a block
  std::array<Survivors, kBlocksAtOnce> at_once_;  // of a group
};

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

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

#include "spaces/batch/mesh-inl.hpp"
#include "spaces/batch/straddlers-inl.hpp"
#include "spaces/batch/streams-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

// The survivors of a block of streams, as vertices one after the other.
template <class S>
class Held {
 public:
  HWY_INLINE void hold(const S& shape, const TriangleStreams& in, std::size_t first,
                       const Survivors& survivors) {
    const std::size_t stride = shape.floats(), attributes = stride - 4;
    for (std::size_t i = 0; i < survivors.count; ++i) {
      const std::size_t t = first + survivors.triangle[i];
      float* const to = memory_ + 3 * i * stride;
      for (std::size_t v = 0; v < 3; ++v) {
        const auto& p = in.positions[v];
        const auto xy = hn::InterleaveLower(kD4, hn::Set(kD4, p[0][t]), hn::Set(kD4, p[1][t]));
        const auto zw = hn::InterleaveLower(kD4, hn::Set(kD4, p[2][t]), hn::Set(kD4, p[3][t]));
        const float* const from = in.attributes + (3 * t + v) * attributes;
        hn::StoreU(hn::ConcatLowerLower(kD4, zw, xy), kD4, to + v * stride);
        std::copy_n(from, attributes, to + v * stride + 4);
      }
    }
  }
  HWY_INLINE const float* vertex(const S& shape, std::size_t i, int v) const {
    return memory_ + (3 * i + static_cast<std::size_t>(v)) * shape.floats();
  }

 private:
  HWY_ALIGN float memory_[kMostBlock * 3 * S::kMostFloats + kSlack];
};

// The stage in its contracts, one call of one of them: the straddlers with the plain version behind
// them, and what a block of triangles needs.
template <class M, int K>
class Stage {
 public:
  Stage(const ClipVolume& volume, int attributes, Output& out)
      : volume_(volume), straddlers_(volume.depth, attributes), access_{out} {
    access_.begin(attributes);
  }

  void copy(const VertexArray& in) {
    const std::size_t stride = straddlers_.shape.floats();
    const std::size_t triangles = in.count / 3;
    bool may_be_inside = true;  // unless a triangle of the block before was outside
    for (std::size_t first = 0; first < triangles;) {
      const float* const block = in.data + 3 * first * stride;
      std::size_t count = std::min(kBlock, triangles - first);
      const std::size_t inside = may_be_inside ? copy_inside(block, first, count) : 0;
      if (inside != 0) {
        count = inside;
      } else {
        classify_block(straddlers_.limits, block, stride, count, survivors_);
        copy_block(block, first, count);
        may_be_inside = survivors_.count == count;
      }
      first += count;
    }
  }

  void reference(const TriangleStreams& in) {
    Held<Shape<K>> held;
    for_each_block(in.count, [&](std::size_t first, std::size_t count) {
      Writer writer = access_.block(count);
      const std::uint32_t* const inside = writer.inside;
      survivors_.count = 0;
      const std::size_t whole = classify_streams(hn::ScalableTag<float>(), straddlers_.limits, in,
                                                 first, count, writer, survivors_);
      for (std::size_t t = whole; t < count; ++t) classify_one(in, first, t, writer);
      count_uncut(count, inside, writer);
      held.hold(straddlers_.shape, in, first, survivors_);
      const auto at = [&](std::size_t i, int v) { return held.vertex(straddlers_.shape, i, v); };
      straddlers_.begin(survivors_);
      for (std::size_t i = 0; i < survivors_.count; ++i) cut(survivors_, i, at, first, writer);
      access_.commit(writer);
    });
  }

  void indexed(const IndexedMesh& mesh) {
    std::uint16_t* const codes = access_.codes(mesh.vertices.count);
    classify_vertices(straddlers_.limits, mesh.vertices, straddlers_.shape.floats(), codes);
    MeshBlock block;
    for_each_block(mesh.indices.size() / 3, [&](std::size_t first, std::size_t count) {
      const auto indices = mesh.indices.subspan(3 * first, 3 * count);
      Writer writer = access_.block(count);
      const std::uint32_t* const inside = writer.inside;
      block.classify(codes, indices);
      block.sort(count, first, writer, survivors_);
      count_uncut(count, inside, writer);
      straddlers_.begin(survivors_);
      cut_survivors(mesh.vertices.data, indices.data(), first, writer);
      access_.commit(writer);
    });
  }

 private:
  // f(first, count) of each, kMostBlock triangles but for the last.
  template <class F>
  static HWY_INLINE void for_each_block(std::size_t triangles, F&& f) {
    for (std::size_t first = 0; first < triangles; first += kMostBlock) {
      f(first, std::min(kMostBlock, triangles - first));
    }
  }

  // Copies triangles from the first on, whole vectors of them, as long as they are inside; returns
  // how many. A processor stores them while it classifies the next ones.
  HWY_INLINE std::size_t copy_inside(const float* block, std::size_t first, std::size_t count) {
    const ClipLimits own = straddlers_.limits;  // no store can be taken for one to them
    const std::size_t stride = straddlers_.shape.floats(), size = 3 * kMostLanes * stride;
    Writer writer = access_.block(count);
    const float* from = block;
    float* to = writer.next;
    std::size_t copied = 0;
    for (; copied + kMostLanes <= count; copied += kMostLanes, from += size, to += size) {
      prefetch_ahead(from, size * sizeof(float));
      if (!hn::AllTrue(kD16, classify_next(own, from, stride).inside)) break;
      copy_floats(kD16, from, size, to);
    }
    writer.add_triangles(copied, [=](std::size_t i) { return first + i; });
    access_.tally().inside += copied;
    access_.commit(writer);
    return copied;
  }

  // Triangles [first, first + count), as classified.
  HWY_INLINE void copy_block(const float* block, std::size_t first, std::size_t count) {
    const std::size_t size = 3 * kBlock * straddlers_.shape.floats();
    Writer writer = access_.block(survivors_.count);
    access_.tally().rejected += count - survivors_.count;
    const auto at = [this, block, shape = straddlers_.shape](std::size_t i, int v) {
      return block + (std::size_t{3} * survivors_.triangle[i] + static_cast<std::size_t>(v)) *
                         shape.floats();
    };
    straddlers_.begin(survivors_);
    NextLines next_block(block + size, size);
    for (std::size_t i = 0; i < survivors_.count;) {
      if (survivors_.any[i] == 0) {
        i = copy_run(block, first, i, writer);
      } else {
        next_block.prefetch_some();
        cut(survivors_, i++, at, first, writer);
      }
    }
    access_.commit(writer);
  }

  // Triangle t of a block that is left over by whole vectors.
  HWY_INLINE void classify_one(const TriangleStreams& in, std::size_t first, std::size_t t,
                               Writer& writer) {
    float position[3][4];
    for (std::size_t v = 0; v < 3; ++v) {
      for (std::size_t c = 0; c < 4; ++c) position[v][c] = in.positions[v][c][first + t];
    }
    const Codes codes = triangle_codes(straddlers_.limits, position[0], 4);
    if (codes.any == 0) *writer.inside++ = static_cast<std::uint32_t>(first + t);
    survivors_.add(t, codes.any, codes.any != 0 && (codes.all & kPlaneBits) == 0);
  }

  // Copies survivors from `begin` on as long as they are inside, and returns the first that is not.
  // Polygons are noted after the vertices: stores to two places in turn take twice as long.
  HWY_INLINE std::size_t copy_run(const float* block, std::size_t first, std::size_t begin,
                                  Writer& writer) const {
    const std::size_t size = 3 * straddlers_.shape.floats();
    float* next = writer.next;
    std::size_t end = begin;
    for (; end < survivors_.count && survivors_.any[end] == 0; ++end, next += size) {
      copy_triangle(straddlers_.shape, block + survivors_.triangle[end] * size, next);
    }
    writer.add_triangles(end - begin,
                         [&](std::size_t i) { return first + survivors_.triangle[begin + i]; });
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
    const std::size_t stride = straddlers_.shape.floats(), count = survivors_.count;
    const auto vertex = [&](std::size_t i, int v) {
      return vertices + indices[3 * survivors_.triangle[i] + v] * stride;
    };
    const auto prefetch = [&](std::size_t i) {
      for (int v = 0; v < 3; ++v) prefetch_floats(vertex(i, v), stride);
    };
    for (std::size_t i = 0; i < std::min(kAhead, count); ++i) prefetch(i);
    for (std::size_t i = 0; i < count; ++i) {
      if (i + kAhead < count) prefetch(i + kAhead);
      cut(survivors_, i, vertex, first, writer);
    }
  }

  // Cuts survivor i of the block that begins at `first`.
  template <class At>
  HWY_INLINE void cut(const Survivors& survivors, std::size_t i, At& at, std::size_t first,
                      Writer& writer) {
    int count = straddlers_.cut(survivors, i, at, writer.next, access_.tally());
    if (HWY_UNLIKELY(count == kGiveUp)) {
      count = plain::cut(kMethod<M>, volume_, straddlers_.shape.attributes, straddlers_.vertices(),
                         writer.next);
    }
    writer.add(first + survivors.triangle[i], count);
  }

  const ClipVolume volume_;
  Straddlers<M, K, float> straddlers_;
  const OutputAccess access_;
  Survivors survivors_;  // of a block
};

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

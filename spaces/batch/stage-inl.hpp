// SPDX-License-Identifier: MIT
//
// The stage in its three output contracts: triangles are classified block by block, without a branch, and
// what survives is copied, named or cut in the order of the input.
#if defined(CLIPSCOPE_BATCH_STAGE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CLIPSCOPE_BATCH_STAGE_INL
#undef CLIPSCOPE_BATCH_STAGE_INL
#else
#define CLIPSCOPE_BATCH_STAGE_INL
#endif

#include <hwy/cache_control.h>

#include "spaces/batch/barycentric-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

// Cuts one triangle of a space at a time by a method. The vertices are of V, and so is what comes out.
template <Method kMethod, int K, class V>
class Cutter {
  static constexpr bool kIsView = kMethod == Method::view;

 public:
  using S = Shape<K>;
  using Limits = std::conditional_t<kIsView, ViewLimits, ClipLimits>;
  using CutPlane = std::conditional_t<kIsView, ViewCodePlane, CodePlane>;

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

  // Vertices written to `out`, or kGiveUp: then the plain version has to do it. any: the bits that some
  // vertex has; not 0.
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
      ++(kMethod == Method::correctly_rounded ? tally.exact : tally.plain);
    }
    return count;
  }

 private:
  static constexpr bool kIsChain =
      kIsView || kMethod == Method::homogeneous || kMethod == Method::homogeneous_double;
  using T = std::conditional_t<kMethod == Method::homogeneous_double, double, V>;
  using ChainOf = Chain<T, S, Limits, CutPlane>;
  using Originals = FromOriginals<kMethod == Method::correctly_rounded, S>;

  static std::array<CodePlane, kPlanes> planes_in(DepthRange depth) {
    auto planes = code_planes(depth);
    if (!kIsChain)
      std::rotate(planes.begin(), planes.begin() + 2, planes.end());  // as `kAllPlanes`
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

  // Triangle t of streams. A vertex of four attributes is stored as one register, since it is loaded as one.
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

// The stage's cutter, with the plain version behind it.
template <Method kMethod, int K>
class StageCutter : public Cutter<kMethod, K, float> {
  using Base = Cutter<kMethod, K, float>;

 public:
  StageCutter(const ClipVolume& volume, int attributes)
      : Base(volume.depth, attributes), volume_(volume) {}

  HWY_NOINLINE void cut_into(const float* const vertex[3], unsigned any, std::size_t triangle,
                             Writer& writer, Tally& tally) const {
    int count = Base::cut(vertex, any, writer.next, tally);
    if (count == kGiveUp) {
      count = plain::cut(kMethod, volume_, Base::shape.attributes, vertex, writer.next);
    }
    writer.add(triangle, count);
  }

 private:
  const ClipVolume volume_;
};

template <Method kMethod, int K>
void clip_copy(const ClipVolume& volume, const VertexArray& in, Output& out) {
  const StageCutter<kMethod, K> cutter(volume, in.attributes);
  const OutputAccess access{out};
  access.begin(in.attributes);
  Padded<Shape<K>> padded;
  Survivors survivors;
  const std::size_t stride = cutter.shape.floats(), triangles = in.count / 3;
  for (std::size_t first = 0; first < triangles; first += kBlock) {
    const std::size_t count = std::min(kBlock, triangles - first);
    const float* block = in.data + first * 3 * stride;
    classify_block(cutter.limits, block, stride, count, survivors);
    Writer writer = access.block(survivors.count);
    Tally& tally = access.tally();
    tally.rejected += count - survivors.count;
    for (std::size_t i = 0; i < survivors.count; ++i) {
      const std::size_t t = survivors.triangle[i];
      const float* v = block + 3 * t * stride;
      if (survivors.any[i] == 0) {
        copy_triangle(cutter.shape, v, writer.next);
        writer.add(first + t, 3);
        ++tally.inside;
      } else {
        padded.set(cutter.shape, v, v + stride, v + 2 * stride);
        cutter.cut_into(padded.vertex, survivors.any[i], first + t, writer, tally);
      }
    }
    access.commit(writer);
  }
}

// Few triangles are cut: what only they need is asked for when they are found.
HWY_INLINE void prefetch_floats(const float* p, std::size_t count) {
  for (std::size_t i = 0; i < count; i += 16) hwy::Prefetch(p + i);
  if (count != 0) hwy::Prefetch(p + count - 1);
}

// The numbers first, first + 1, … of the lanes that are set; returns where the next number goes. Where an
// instruction does not do it, Highway looks a permutation up in a table that GCC copies to the stack each
// time, 1 KB: this takes a quarter of that.
template <class D>
HWY_INLINE std::uint32_t* append_numbers(D d, std::size_t first, hn::Mask<D> lanes,
                                         std::uint32_t* to) {
  if constexpr (hn::MaxLanes(D()) > 8) {
    const auto numbers = hn::Iota(d, static_cast<std::uint32_t>(first));
    return to + hn::CompressStore(numbers, lanes, d, to);
  } else {
    const unsigned bits = mask_bits(d, lanes);
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
      *to = static_cast<std::uint32_t>(first + lane);
      to += bits >> lane & 1;
    }
    return to;
  }
}

// Classifies triangles [first, first + count) in whole vectors, and returns how many that are: numbers of those
// inside go to the writer, others that survive, counted from `first`, to the list.
template <class D>
HWY_INLINE std::size_t classify_streams(D d, const ClipLimits& limits, const TriangleStreams& in,
                                        std::size_t first, std::size_t count, Writer& writer,
                                        Survivors& out) {
  const hn::RebindToUnsigned<D> du;
  const bool from_zero = limits.keep[6] == 0;
  const auto floats = 3 * static_cast<std::size_t>(in.attribute_count);  // attributes of a triangle
  std::size_t t = 0;
  for (; t + hn::Lanes(d) <= count; t += hn::Lanes(d)) {
    // Per plane: whether some vertex is inside; and whether all are, of all planes.
    hn::Mask<D> some[kPlanes], every;
    auto least_w = hn::Zero(d), most_w = hn::Zero(d);
    for (int v = 0; v < 3; ++v) {
      const auto& p = in.positions[v];
      const auto x = hn::LoadU(d, p[0] + first + t), y = hn::LoadU(d, p[1] + first + t),
                 z = hn::LoadU(d, p[2] + first + t), w = hn::LoadU(d, p[3] + first + t);
      const auto minus_w = hn::Neg(w);
      const hn::Mask<D> in_plane[kPlanes] = {
          hn::Le(x, w),       hn::Le(y, w),       hn::Le(z, w),
          hn::Le(minus_w, x), hn::Le(minus_w, y), hn::Le(from_zero ? hn::Zero(d) : minus_w, z)};
      for (int i = 0; i < kPlanes; ++i) {
        some[i] = v == 0 ? in_plane[i] : hn::Or(some[i], in_plane[i]);
        every = v == 0 && i == 0 ? in_plane[i] : hn::And(every, in_plane[i]);
      }
      least_w = v == 0 ? w : hn::Min(least_w, w);
      most_w = v == 0 ? w : hn::Max(most_w, w);
    }
    hn::Mask<D> survives = some[0];
    for (int i = 1; i < kPlanes; ++i) survives = hn::And(survives, some[i]);
    if (hn::AllFalse(d, survives)) continue;
    // Where `every` holds no w is NaN.
    const auto inside =
        hn::And(every, hn::And(hn::Le(most_w, hn::Set(d, kLargest)), hn::Gt(least_w, hn::Zero(d))));
    writer.inside = append_numbers(du, first + t, hn::RebindMask(du, inside), writer.inside);
    for (unsigned rest = mask_bits(d, hn::AndNot(inside, survives)); rest != 0; rest &= rest - 1) {
      const auto cut = t + static_cast<std::size_t>(std::countr_zero(rest));
      out.triangle[out.count++] = static_cast<std::uint16_t>(cut);
      prefetch_floats(in.attributes + (first + cut) * floats, floats);
    }
  }
  return t;
}

// The bits that some of three vertices have, and those that all have.
HWY_INLINE Codes codes_of(const ClipLimits& limits, const float* const vertex[3]) {
  const unsigned a = vertex_code(limits, vertex[0]), b = vertex_code(limits, vertex[1]),
                 c = vertex_code(limits, vertex[2]);
  return {a & b & c, a | b | c};
}

template <Method kMethod, int K>
void clip_reference(const ClipVolume& volume, const TriangleStreams& in, Output& out) {
  const StageCutter<kMethod, K> cutter(volume, in.attribute_count);
  const OutputAccess access{out};
  access.begin(in.attribute_count);
  Padded<Shape<K>> padded;
  Survivors survivors;
  for (std::size_t first = 0; first < in.count; first += kBlock) {
    const std::size_t count = std::min(kBlock, in.count - first);
    Writer writer = access.block(count);
    const std::uint32_t* inside = writer.inside;
    survivors.count = 0;
    std::size_t t = classify_streams(hn::ScalableTag<float>(), cutter.limits, in, first, count,
                                     writer, survivors);
    for (; t < count; ++t) {  // what is left of a vector
      padded.set(cutter.shape, in, first + t);
      const Codes codes = codes_of(cutter.limits, padded.vertex);
      if (codes.any == 0) *writer.inside++ = static_cast<std::uint32_t>(first + t);
      survivors.triangle[survivors.count] = static_cast<std::uint16_t>(t);
      survivors.count += codes.any != 0 && (codes.all & kPlaneBits) == 0;
    }
    Tally& tally = access.tally();
    const auto inside_count = static_cast<std::size_t>(writer.inside - inside);
    tally.inside += inside_count;
    tally.rejected += count - inside_count - survivors.count;
    for (std::size_t i = 0; i < survivors.count; ++i) {
      padded.set(cutter.shape, in, first + survivors.triangle[i]);
      const unsigned any = codes_of(cutter.limits, padded.vertex).any;
      cutter.cut_into(padded.vertex, any, first + survivors.triangle[i], writer, tally);
    }
    access.commit(writer);
  }
}

// Codes of all vertices of a mesh.
template <int K>
HWY_INLINE void classify_vertices(const Shape<K>& shape, const ClipLimits& limits,
                                  const VertexArray& in, std::uint8_t* codes) {
  const float* v = in.data;
  for (std::size_t i = 0; i < in.count; ++i, v += shape.floats()) {
    codes[i] = static_cast<std::uint8_t>(vertex_code(limits, v));
  }
}

template <Method kMethod, int K>
void clip_indexed(const ClipVolume& volume, const IndexedMesh& mesh, Output& out) {
  const StageCutter<kMethod, K> cutter(volume, mesh.vertices.attributes);
  const OutputAccess access{out};
  access.begin(mesh.vertices.attributes);
  std::uint8_t* const codes = access.codes(mesh.vertices.count);
  classify_vertices(cutter.shape, cutter.limits, mesh.vertices, codes);
  Padded<Shape<K>> padded;
  Survivors survivors;
  const std::size_t stride = cutter.shape.floats(), triangles = mesh.indices.size() / 3;
  for (std::size_t first = 0; first < triangles; first += kBlock) {
    const std::size_t count = std::min(kBlock, triangles - first);
    const std::uint32_t* indices = mesh.indices.data() + 3 * first;
    Writer writer = access.block(count);
    std::uint32_t* inside = writer.inside;
    survivors.count = 0;
    for (std::size_t t = 0; t < count; ++t) {
      const unsigned a = codes[indices[3 * t]], b = codes[indices[3 * t + 1]],
                     c = codes[indices[3 * t + 2]], any = a | b | c;
      *inside = static_cast<std::uint32_t>(first + t);
      inside += any == 0;
      survivors.triangle[survivors.count] = static_cast<std::uint16_t>(t);
      survivors.any[survivors.count] = static_cast<std::uint8_t>(any);
      survivors.count += any != 0 && (a & b & c & kPlaneBits) == 0;
    }
    Tally& tally = access.tally();
    const auto inside_count = static_cast<std::size_t>(inside - writer.inside);
    writer.inside = inside;
    tally.inside += inside_count;
    tally.rejected += count - inside_count - survivors.count;
    constexpr std::size_t kAhead = 8;
    const auto prefetch = [&](std::size_t i) {
      for (int v = 0; v < 3; ++v) {
        const std::uint32_t index = indices[3 * survivors.triangle[i] + v];
        prefetch_floats(mesh.vertices.data + index * stride, stride);
      }
    };
    for (std::size_t i = 0; i < std::min<std::size_t>(kAhead, survivors.count); ++i) prefetch(i);
    for (std::size_t i = 0; i < survivors.count; ++i) {
      if (i + kAhead < survivors.count) prefetch(i + kAhead);
      const std::size_t t = survivors.triangle[i];
      const auto at = [&](int v) { return mesh.vertices.data + indices[3 * t + v] * stride; };
      padded.set(cutter.shape, at(0), at(1), at(2));
      cutter.cut_into(padded.vertex, survivors.any[i], first + t, writer, tally);
    }
    access.commit(writer);
  }
}

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

// SPDX-License-Identifier: MIT
//
// The full contract: view space in, NDC out. A block of triangles is brought into the space where it is
// cut, classified and cut as in the stage, and divided.
//
//   view                             cut in view space, then projected
//   homogeneous                      projected in float
//   homogeneous_double, barycentric  projected, cut and divided in double; rounded to float at the end
#if defined(CLIPSCOPE_BATCH_FULL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CLIPSCOPE_BATCH_FULL_INL
#undef CLIPSCOPE_BATCH_FULL_INL
#else
#define CLIPSCOPE_BATCH_FULL_INL
#endif

#include "spaces/batch/plain_triangle.hpp"
#include "spaces/batch/stage-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

// The rows of a projection matrix by lane, so that a position (x, y, z, …) becomes own (x, y, z, z) +
// z_weight (z, z, z, z) + one, with the bits of `to_clip`.
template <class V>
class ProjectionLanes {
  using D = hn::CappedTag<V, 4>;

 public:
  explicit ProjectionLanes(const Projection<V>& p)
      : own_{p.x.own, p.y.own, p.z.z, p.w.z},
        z_weight_{p.x.z, p.y.z, 0, 0},
        one_{p.x.one, p.y.one, p.z.one, p.w.one} {}

  // Of four readable floats; in place is allowed.
  template <class From>
  HWY_INLINE void project(const From* v, V* out) const {
    const D d;
    const V x = v[0], y = v[1], z = v[2];
    HWY_ALIGN const V point[4] = {x, y, z, z};
    const auto vz = hn::Set(d, z);
    for (std::size_t i = 0; i < 4; i += hn::Lanes(d)) {
      const auto sum = hn::Add(hn::Mul(hn::Load(d, own_ + i), hn::Load(d, point + i)),
                               hn::Mul(hn::Load(d, z_weight_ + i), vz));
      hn::StoreU(hn::Add(sum, hn::Load(d, one_ + i)), d, out + i);
    }
  }

 private:
  HWY_ALIGN V own_[4], z_weight_[4], one_[4];
};

// Divides a clip-space position by its w, in place: (x, y, z, 1) / w. Whether w was finite and
// positive, and x, y, z are finite.
template <class V>
HWY_INLINE bool divide_in_place(V* v) {
  const hn::CappedTag<V, 4> d;
  const V w = v[3];
  v[3] = 1;
  bool finite = w > 0 && w <= std::numeric_limits<V>::max();
  for (std::size_t i = 0; i < 4; i += hn::Lanes(d)) {
    hn::StoreU(hn::Div(hn::LoadU(d, v + i), hn::Set(d, w)), d, v + i);
  }
  for (int c = 0; c < 3; ++c) finite = finite && std::abs(v[c]) <= std::numeric_limits<V>::max();
  return finite;
}

template <Method kMethod>
inline constexpr bool kIsInDouble =
    kMethod == Method::homogeneous_double || kMethod == Method::barycentric;

template <Method kMethod, int K>
class FullClipper {
  using V = std::conditional_t<kIsInDouble<kMethod>, double, float>;
  using S = Shape<K>;

 public:
  FullClipper(const Projection<float>& projection, int attributes)
      : projection_(projection),
        cutter_(make_cutter(projection, attributes)),
        lanes_(plain::projection_in<V>(projection)) {}

  void operator()(const ViewVertexArray& in, Output& out) const {
    const OutputAccess access{out};
    access.begin(in.attributes);
    const auto memory = std::make_unique_for_overwrite<Block>();
    const S& shape = cutter_.shape;
    const std::size_t stride = shape.floats(), from = stride - 1, triangles = in.count / 3;
    for (std::size_t first = 0; first < triangles; first += kBlock) {
      const std::size_t count = std::min(kBlock, triangles - first);
      const float* block = in.data + first * 3 * from;
      for (std::size_t v = 0; v < 3 * count; ++v) {
        bring(block + v * from, memory->vertices + v * stride);
      }
      classify_block(cutter_.limits, memory->vertices, stride, count, memory->survivors);
      clip_survivors(block, first, count, *memory, access);
    }
  }

 private:
  // What a block needs beside its results. Whole vectors are read and written.
  struct Block {
    HWY_ALIGN V vertices[kBlock * 3 * S::kMostFloats + kSlack];
    HWY_ALIGN V polygon[kMostVertices * S::kMostFloats + kSlack];
    Padded<S, V> padded;
    Survivors survivors;
  };

  static Cutter<kMethod, K, V> make_cutter(const Projection<float>& projection, int attributes) {
    if constexpr (kMethod == Method::view) {
      return {projection.frustum, attributes};
    } else {
      return {projection.volume.depth, attributes};
    }
  }

  // A view-space vertex into the space where it is cut: (x, y, z, 1) or clip space.
  HWY_INLINE void bring(const float* v, V* out) const {
    if constexpr (kMethod == Method::view) {
      for (int c = 0; c < 3; ++c) out[c] = v[c];
      out[3] = 1;
    } else {
      lanes_.project(v, out);
    }
    const std::size_t attributes = cutter_.shape.floats() - 4;
    for (std::size_t k = 0; k < attributes; ++k) out[4 + k] = v[3 + k];
  }

  HWY_INLINE void clip_survivors(const float* block, std::size_t first, std::size_t count,
                                 Block& memory, const OutputAccess& access) const {
    const S& shape = cutter_.shape;
    const std::size_t stride = shape.floats();
    const Survivors& survivors = memory.survivors;
    Writer writer = access.block(survivors.count);
    Tally& tally = access.tally();
    tally.rejected += count - survivors.count;
    for (std::size_t i = 0; i < survivors.count; ++i) {
      const std::size_t t = survivors.triangle[i];
      const V* v = memory.vertices + 3 * t * stride;
      int vertices = 3;
      if (survivors.any[i] == 0) {
        ++tally.inside;
        vertices = finish(v, 3, writer.next);
      } else {
        memory.padded.set(shape, v, v + stride, v + 2 * stride);
        vertices = cutter_.cut(memory.padded.vertex, survivors.any[i], memory.polygon, tally);
        if (vertices != kGiveUp) vertices = finish(memory.polygon, vertices, writer.next);
      }
      if (vertices == kGiveUp) {
        vertices = plain::cut_full(kMethod, projection_, shape.attributes,
                                   block + 3 * t * (stride - 1), writer.next);
      }
      writer.add(first + t, vertices);
    }
    access.commit(writer);
  }

  // Vertices of the space of the cut to NDC, rounded to float; how many, or kGiveUp where something is
  // not finite.
  HWY_INLINE int finish(const V* v, int count, float* out) const {
    const std::size_t stride = cutter_.shape.floats();
    for (int i = 0; i < count; ++i, v += stride, out += stride) {
      HWY_ALIGN V position[4];
      if constexpr (kMethod == Method::view) {
        lanes_.project(v, position);
      } else {
        std::copy(v, v + 4, position);
      }
      const bool finite = divide_in_place(position);
      copy_vertex(cutter_.shape, v, out);
      for (int c = 0; c < 4; ++c) out[c] = static_cast<float>(position[c]);
      if (!finite) return kGiveUp;
    }
    return count;
  }

  const Projection<float>& projection_;
  const Cutter<kMethod, K, V> cutter_;
  const ProjectionLanes<V> lanes_;
};

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
